# Runs a command in the environment, on as many MPI ranks as asked for.

# Sets `prefix`: what stands before the command; `build` and `inside` are known by now.
make_prefix() {
    local cores paths=$checkout/python:$build
    cores=$(nproc 2>/dev/null || echo 1)
    [ ${#inside[@]} -gt 0 ] || paths+=${PYTHONPATH:+:$PYTHONPATH}
    # The ranks of one machine talk through shared memory; without TCP no network interface is missed.
    prefix=("${inside[@]}" env "PYTHONPATH=$paths" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
        "OMPI_MCA_btl=${OMPI_MCA_btl:-^tcp}"
        # Ranks that wait for each other leave the core to who needs it: on a loaded machine it takes hours otherwise.
        "OMPI_MCA_mpi_yield_when_idle=${OMPI_MCA_mpi_yield_when_idle:-1}"
        # The fronts of a rope's factorisation are small: two BLAS threads took 2.4 times as long as one.
        "OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}" "OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1}")
    [ "$ranks" -gt 1 ] || return 0
    prefix+=(mpirun -n "$ranks")
    if "${inside[@]}" mpirun --version 2>/dev/null | grep -q 'Open MPI'; then
        prefix+=(--bind-to none)
        [ "$ranks" -le "$cores" ] || prefix+=(--map-by :OVERSUBSCRIBE)
    fi
}

# mpirun takes no notice of a signal while it starts its processes: the signal is sent until $job has ended.
end_job() {
    while kill "$job" 2>/dev/null; do sleep 2; done
}

# Under mpirun: an interrupt ends all processes before one of them could tell how to go on.
launch_ranks() {
    local job code=0 interrupted=''
    (trap - INT && exec "$@") <&0 &
    job=$!
    # A terminal interrupts mpirun, too, which takes a second to end its processes; others may interrupt this one only.
    trap 'interrupted=yes; sleep 2; end_job' INT
    trap 'interrupted=yes; end_job' TERM HUP
    while kill -0 "$job" 2>/dev/null; do
        code=0
        wait "$job" || code=$?
    done
    if [ -n "$interrupted" ]; then
        note "interrupted: the same command with --resume goes on from the last increment"
        code=130
    fi
    exit "$code"
}

# launch COMMAND...: takes this process's place, so that signals and the exit code are the command's own.
launch() {
    make_prefix
    if [ -n "${BRAIDX_DRY_RUN:-}" ]; then
        # As it can be pasted into a shell, with what enter.sh finds in its environment.
        set -- env "BRAIDX_CHECKOUT=$checkout" "BRAIDX_CACHE=$cache" "BRAIDX_UID=$BRAIDX_UID" "BRAIDX_GID=$BRAIDX_GID" \
            "${prefix[@]}" "$@"
        printf '%q' "$1"
        printf ' %q' "${@:2}"
        echo
        exit
    fi
    [ "$ranks" = 1 ] || launch_ranks "${prefix[@]}" "$@"
    exec "${prefix[@]}" "$@"
}

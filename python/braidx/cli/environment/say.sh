# How the launcher talks (to standard error), waits and gives up.

note() { printf 'braidx: %s\n' "$*" >&2; }

stop() {
    note "$*"
    exit 2
}

# step NAME COMMAND...: runs a long command with its output in a log, showing the phase and seconds on one
# line (a line per phase where no terminal listens); the whole log if it fails.
step() {
    local name=$1 log=$cache/step.log start=$SECONDS job phase last='' code=0
    shift
    note "$name"
    set -m # a process group of its own, so that an interrupt ends all of it
    "$@" >"$log" 2>&1 </dev/null &
    job=$!
    set +m
    trap 'kill -- "-$job" 2>/dev/null; wait "$job"; echo >&2; note "interrupted"; exit 130' INT TERM HUP
    while kill -0 "$job" 2>/dev/null; do
        phase=$(tr '\r' '\n' <"$log" | grep -E '^(I: |Get:|Unpacking|Setting up|\[[0-9]+/)' | tail -n 1 | cut -c 1-90 || true)
        if [ -t 2 ]; then
            printf '\r\033[K  %4d s  %s' $((SECONDS - start)) "$phase" >&2
        elif [ "${phase%% *}" = I: ] && [ "$phase" != "$last" ]; then
            printf '  %4d s  %s\n' $((SECONDS - start)) "$phase" >&2
            last=$phase
        fi
        sleep 0.5
    done
    wait "$job" || code=$?
    trap - INT TERM HUP
    if [ -t 2 ]; then printf '\r\033[K' >&2; fi
    if [ "$code" = 0 ]; then note "  done in $((SECONDS - start)) s"; else cat "$log" >&2; fi
    return "$code"
}

# lock FILE REASON: one launcher at a time; unlock lets the next one in (as does the end of this one).
lock() {
    exec 9>"$1"
    flock --nonblock 9 && return
    note "waiting: $2"
    flock 9
}

unlock() { exec 9>&-; }

# How the launcher talks (to standard error), waits and gives up.

note() { printf 'braidx: %s\n' "$*" >&2; }

stop() {
    note "$*"
    exit 2
}

# Size of a folder, GB.
size_of() { du -s --block-size=1M "$1" 2>/dev/null | awk '{ printf "%.1f GB", $1 / 1000 }'; }

# step NAME COMMAND...: runs a long command with its output in a log; the log is shown if it fails. Meanwhile
# a line tells seconds, the size of the folder $growing and the current phase: rewritten twice a second on a
# terminal, else printed every 30 s.
step() {
    local name=$1 log=$cache/step.$$.log start=$SECONDS job next=30 size='' code=0
    shift
    note "$name"
    set -m # a process group of its own, so that an interrupt ends all of it
    "$@" >"$log" 2>&1 </dev/null &
    job=$!
    set +m
    trap 'kill -- "-$job" 2>/dev/null; wait "$job" || true; rm -f "$log"; echo >&2; note "interrupted"; exit 130' INT TERM HUP
    while kill -0 "$job" 2>/dev/null; do
        sleep 0.5
        if [ -n "${growing:-}" ] && [ $((SECONDS % 5)) = 0 ]; then size=$(size_of "$growing"); fi
        if [ -t 2 ]; then
            printf '\r\033[K  %4d s  %s  %s' $((SECONDS - start)) "$size" "$(phase "$log")" >&2
        elif [ $((SECONDS - start)) -ge "$next" ]; then
            next=$((next + 30))
            printf '  %4d s  %s  %s\n' $((SECONDS - start)) "$size" "$(phase "$log")" >&2
        fi
    done
    wait "$job" || code=$?
    trap - INT TERM HUP
    if [ -t 2 ]; then printf '\r\033[K' >&2; fi
    if [ "$code" = 0 ]; then note "  done in $((SECONDS - start)) s"; else cat "$log" >&2; fi
    rm -f "$log"
    return "$code"
}

# The last line of a log that tells what mmdebstrap, apt or Ninja is doing.
phase() {
    tr '\r' '\n' <"$1" | grep -a -E '^(I: |Get:|Unpacking|Setting up|\[[0-9]+/)' | tail -n 1 | cut -c 1-70 || true
}

# lock FILE REASON: one launcher at a time; unlock lets the next one in (as does the end of this one).
lock() {
    exec 9>"$1"
    flock --nonblock 9 && return
    note "waiting: $2"
    flock 9
}

unlock() { exec 9>&-; }

# Chooses where braidx runs. Sets the array `inside` (a command prefix, empty on the host itself), `python`,
# and `environment` (a name that differs between environments whose builds must not mix).
#
# In this order: a Python that has everything; the private Debian root of an earlier start; apt, where the
# distribution ships DOLFINx >= 0.9 and we are root; a new private root; an error that says what to do.

use_host_python() {
    local lacking
    command -v "$1" >/dev/null || return 1
    lacking=$("$1" "$here/probe.py" 2>/dev/null) || return 1
    if [ -n "$lacking" ]; then
        case $lacking in *DOLFINx* | *Python*) ;; *) note "$1 has DOLFINx but lacks: $lacking (pip install them to use it)" ;; esac
        return 1
    fi
    inside=()
    python=$(command -v "$1")
    environment=${BRAIDX_ROOT:-$python}
}

use_any_host_python() {
    local candidate
    for candidate in python3 /usr/bin/python3 /dolfinx-env/bin/python3; do
        use_host_python "$candidate" && return
    done
    return 1
}

# True if this distribution's archive ships DOLFINx >= 0.9 (Debian 13, Ubuntu 25.04 and later).
apt_has_dolfinx() {
    local version
    version=$(LC_ALL=C apt-cache policy python3-dolfinx-real python3-dolfinx 2>/dev/null |
        sed -n 's/^ *Candidate: *\([0-9].*\)/\1/p' | head -n 1)
    [ -n "$version" ] && dpkg --compare-versions "${version#*:}" ge 0.9
}

apt_install() {
    DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "$@"
}

use_named_python() {
    local lacking
    use_host_python "$BRAIDX_PYTHON" && return
    command -v "$BRAIDX_PYTHON" >/dev/null ||
        stop "BRAIDX_PYTHON=$BRAIDX_PYTHON: there is no such program; name a Python with DOLFINx 0.9 or later, or unset it"
    lacking=$("$BRAIDX_PYTHON" "$here/probe.py" 2>&1 | tail -n 1) || stop "BRAIDX_PYTHON=$BRAIDX_PYTHON is no Python: $lacking"
    stop "BRAIDX_PYTHON=$BRAIDX_PYTHON lacks: $lacking"
}

# What is here already, without any installation.
choose_present() {
    if [ -n "${BRAIDX_PYTHON:-}" ]; then
        use_named_python
        return
    fi
    [ -z "${BRAIDX_PRIVATE_ROOT:-}" ] && use_any_host_python && return
    private_root_is_complete && use_private_root
}

choose() {
    choose_present && return
    lock "$cache/environment.lock" "another braidx is preparing the environment"
    if private_root_is_complete || update_private_root; then
        use_private_root
    else
        prepare
    fi
    unlock
}

prepare() {
    if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        step "apt-get update" apt-get update || note "going on with the package lists at hand"
        if [ -z "${BRAIDX_PRIVATE_ROOT:-}" ] && apt_has_dolfinx; then
            local packages
            mapfile -t packages <"$here/debian.txt"
            step "installing DOLFINx and its tools with apt (about 2.5 GB)" apt_install "${packages[@]}" ||
                stop "apt-get install failed"
            use_host_python /usr/bin/python3 || stop "/usr/bin/python3 still lacks: $(/usr/bin/python3 "$here/probe.py")"
            return
        fi
        command -v mmdebstrap >/dev/null ||
            step "installing mmdebstrap" apt_install mmdebstrap debian-archive-keyring || true
    fi
    command -v mmdebstrap >/dev/null && "${namespace[@]}" true 2>/dev/null || stop_with_advice
    [ "$(id -u)" = 0 ] || check_subordinate_ids
    make_private_root
    use_private_root
}

# Without root mmdebstrap gives the files of the root user ids of a range that the user owns.
check_subordinate_ids() {
    local user file
    user=$(id -un)
    command -v newuidmap >/dev/null ||
        stop "a private Debian without root takes newuidmap, of the package uidmap: sudo apt install uidmap"
    for file in /etc/subuid /etc/subgid; do
        grep -q -E "^($user|$(id -u)):" "$file" 2>/dev/null || stop "a private Debian without root takes a range of \
user ids, and $file has none for $user: sudo usermod --add-subuids 100000-165535 --add-subgids 100000-165535 $user"
    done
}

stop_with_advice() {
    local apt="sudo apt install mmdebstrap uidmap   (then ./braidx again, without sudo)"
    if apt_has_dolfinx; then apt="sudo apt install --no-install-recommends \$(cat '$here/debian.txt')"; fi
    stop "DOLFINx >= 0.9 not found, and it cannot be installed here: that takes root and apt, or mmdebstrap
  and the right to mount. Use one of
    apt:     $apt
    conda:   conda env create -f '$checkout/environment.yml' && conda activate braidx
    Docker:  docker build -t braidx '$checkout' && docker run --rm -it --user \"\$(id -u):\$(id -g)\" -v \"\$PWD:/data\" braidx demo
  or name a Python that has it: BRAIDX_PYTHON=/path/to/python3"
}

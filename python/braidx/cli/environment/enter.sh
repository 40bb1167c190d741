# Runs a command inside a private root: enter.sh ROOT COMMAND [ARGUMENT ...]
#
# Started in a mount namespace of its own (unshare --mount), so the mounts below vanish with the command and
# nobody else sees them. Ends in exec: signals, exit code and terminal are the command's own. Every top-level
# directory that is the user's rather than the distribution's is seen at its place.
set -eu
root=$1
shift
directory=$PWD

show() {
    [ -d "$1" ] && ! [ "$root$1" -ef "$1" ] || return 0
    mkdir -p "$root$1"
    mount --rbind "$1" "$root$1" || echo "braidx: $1 cannot be seen inside the private root" >&2
}

for path in /*; do
    case $path in
    /bin | /boot | /etc | /lib* | /lost+found | /run | /sbin | /usr | /var | /dev | /proc | /sys) ;;
    *) [ -L "$path" ] || show "$path" ;;
    esac
done
for path in /var/tmp /dev /proc /sys; do show "$path"; done
# What is used may also lie elsewhere; a folder that the root has something in (/, /usr/lib) stays the root's.
for path in "$HOME" "${TMPDIR:-/tmp}" "$directory" "$BRAIDX_CHECKOUT" "$BRAIDX_CACHE"; do
    [ -n "$(ls -A "$root$path" 2>/dev/null)" ] || show "$path"
done
names=(/etc/resolv.conf /etc/hosts)
become=(chroot "$root")
if [ "$BRAIDX_UID" != 0 ]; then # a user who became root only to mount becomes himself again
    names+=(/etc/passwd /etc/group)
    become=(unshare --user --map-user="$BRAIDX_UID" --map-group="$BRAIDX_GID" --root="$root" --)
fi
for path in "${names[@]}"; do
    [ -e "$path" ] && [ -f "$root$path" ] && mount --bind "$path" "$root$path"
done

unset PYTHONPATH PYTHONHOME VIRTUAL_ENV LD_LIBRARY_PATH LD_PRELOAD PETSC_DIR PETSC_ARCH
export BRAIDX_ROOT="$root" PYTHONNOUSERSITE=1 LC_ALL=C.UTF-8 PATH=/usr/bin:/bin:/usr/sbin:/sbin
exec "${become[@]}" /usr/bin/env --chdir="$directory" "$@"

# A private Debian in the user's cache: made once by mmdebstrap, entered by enter.sh. Nothing of the host changes. It
# is built under another name and renamed when complete, so an interrupted set-up starts afresh.
#
# BRAIDX_PRIVATE_ROOT=sid makes one of that release instead of Debian 13; each has a root of its own.

case ${BRAIDX_PRIVATE_ROOT:-1} in
1) release=trixie private_root=$cache/debian13 ;;
*) release=$BRAIDX_PRIVATE_ROOT private_root=$cache/debian-$BRAIDX_PRIVATE_ROOT ;;
esac
private_root_list=$private_root/etc/braidx-packages # the list it was made from: its stamp

# A mount namespace of its own for a command; without root also a user namespace, to be allowed to mount.
namespace=(unshare --mount --)
[ "$(id -u)" = 0 ] || namespace=(unshare --user --map-root-user --mount --)

private_root_is_complete() { cmp -s "$here/debian.txt" "$private_root_list"; }

use_private_root() {
    inside=("${namespace[@]}" bash "$here/enter.sh" "$private_root")
    python=/usr/bin/python3
    environment=$private_root
}

# The host's Debian mirror if it has one of its own that also carries the release, else nothing (the default).
mirror() {
    local uri
    command -v apt-get >/dev/null || return 0
    uri=$(apt-get indextargets --format '$(ORIGIN) $(REPO_URI)' 2>/dev/null |
        awk '$1 == "Debian" && $2 !~ /security|deb\.debian\.org/ { print $2; exit }')
    [ -n "$uri" ] && /usr/lib/apt/apt-helper download-file "${uri%/}/dists/$release/Release" \
        "$cache/Release" >/dev/null 2>&1 && echo "$uri"
    rm -f "$cache/Release"
}

# The host's apt settings for proxies and certificates, as options of mmdebstrap, one per line.
apt_settings() {
    command -v apt-config >/dev/null || return 0
    apt-config dump Acquire 2>/dev/null |
        grep -E '^Acquire::(Retries|Check-|(http|https|ftp)[^"]*(Proxy|CaInfo|Verify|Retries))[^"]* "[^"]+"' |
        sed 's/^/--aptopt=/' || true
}

# A root made from another list (an older braidx's) only gets what it lacks.
update_private_root() {
    local packages
    [ -d "$private_root" ] && [ "$(id -u)" = 0 ] || return 1
    mapfile -t packages <"$here/debian.txt"
    use_private_root
    cp /etc/resolv.conf "$private_root/etc/resolv.conf"
    step "updating the private Debian in $private_root" "${inside[@]}" bash -ec '
        export DEBIAN_FRONTEND=noninteractive
        apt-get update
        apt-get install --yes --no-install-recommends "$@"' - "${packages[@]}" || return 1
    cp "$here/debian.txt" "$private_root_list"
}

make_private_root() {
    local partial=$private_root.partial packages options growing
    growing=$cache
    mapfile -t packages <"$here/debian.txt"
    rm -rf --one-file-system "$partial" "$private_root"
    note "DOLFINx >= 0.9 is not here: making a private Debian ($release) with it in $private_root (once; about 5 minutes and 2.5 GB)"
    mapfile -t options < <(apt_settings)
    options+=(--variant=minbase --include="$(IFS=,; echo "${packages[*]}")"
        --dpkgopt=force-unsafe-io --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/doc/*')
    step "downloading and unpacking" debootstrap_into "$partial" "${options[@]}" ||
        stop "the private Debian could not be made (log above). Remedies: a network connection to
    deb.debian.org (http_proxy is honoured), 4 GB free in $cache, or conda / Docker as README.md says"
    cp "$here/debian.txt" "$partial/etc/braidx-packages"
    mv "$partial" "$private_root"
    note "environment ready: $(size_of "$private_root"), $SECONDS s"
}

# Without root the files would belong to foreign user ids; a tar stream makes them the user's own.
debootstrap_into() {
    local target=$1
    shift
    if [ "$(id -u)" = 0 ]; then
        "${namespace[@]}" mmdebstrap "$@" "$release" "$target" $(mirror)
    else
        mkdir -p "$target"
        TMPDIR=$cache mmdebstrap --mode=unshare "$@" "$release" - $(mirror) | tar -x --exclude='./dev/*' -C "$target"
    fi
}

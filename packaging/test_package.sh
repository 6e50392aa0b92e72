#!/usr/bin/env bash
# Installs the packages in a fresh Debian 13 root, starts the daemon there as its user, solves, and removes everything:
#   packaging/test_package.sh FOLDER_OF_THE_PACKAGES [MIRROR]
# Requires mmdebstrap and the network. No files remain: mmdebstrap removes the root.
set -euo pipefail

here=$(dirname "$(readlink -f "$0")")
packages=$(readlink -f "$1")
shift
mode=auto
[ "$(id -u)" -eq 0 ] || mode=unshare
staged=$(mktemp -d)
trap 'rm -rf "$staged"' EXIT
cp "$packages"/*.deb "$here"/test_installed.* "$here/../client/c/example/cattaneo.c" "$here/../client/cntc/example/creep_forces.c" "$staged/"
chmod -R a+rX "$staged"

mmdebstrap --variant=apt --mode="$mode" --format=null \
    --customize-hook="copy-in $staged/. /root" \
    --customize-hook='chroot "$1" sh -eu /root/test_installed.sh /root' \
    trixie /dev/null "$@"

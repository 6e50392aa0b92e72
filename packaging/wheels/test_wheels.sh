#!/usr/bin/env bash
# packaging/wheels/test_wheels.sh ROOT WHEELS: installs, uses and removes the wheels in empty environments in ROOT, a
# read-only Debian root with Python. The settings of pip on this machine apply there, too.
set -euo pipefail

repository=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
root=$(realpath "$1")
wheels=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

binds=()
for file in /etc/{passwd,group,hosts,resolv.conf,nsswitch.conf,ssl/certs/ca-certificates.crt}; do
    if [ -e "$file" ] && [ -e "$root$file" ]; then binds+=(--ro-bind "$(readlink -f "$file")" "$file"); fi
done
if [ -e /etc/pip.conf ]; then binds+=(--ro-bind /etc/pip.conf /tmp/pip.conf --setenv PIP_CONFIG_FILE /tmp/pip.conf); fi
while IFS='=' read -r name value; do
    binds+=(--setenv "$name" "$value")
done < <(env | grep -iE '^(PIP_|https?_proxy=|no_proxy=|SSL_CERT_FILE=|REQUESTS_CA_BUNDLE=)')

bwrap --clearenv --setenv PATH /usr/bin:/bin --setenv HOME /home --setenv LC_ALL C.UTF-8 \
    --ro-bind "$root" / --dev /dev --proc /proc --ro-bind /sys /sys --tmpfs /tmp --tmpfs /run --tmpfs /srv --bind "$scratch" /home \
    --ro-bind "$wheels" /srv/wheels --ro-bind "$repository/docs" /srv/docs \
    --ro-bind "$repository/packaging" /srv/packaging \
    --ro-bind "$repository/tests/support/contact_hertz.py" /srv/support/contact_hertz.py \
    "${binds[@]}" --chdir /home --unshare-pid --die-with-parent \
    bash /srv/packaging/wheels/use_wheels.sh

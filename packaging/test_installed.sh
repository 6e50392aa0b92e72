# Runs inside the fresh root of test_package.sh, as root: sh test_installed.sh FOLDER
folder=$1
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
say() { echo "package test: $*" >&2; }
fail() { say "$*"; exit 1; }

# Lists the files that a package leaves: all except those that dpkg and apt keep, and the logs of installing.
files() {
    find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path "$folder" \
        -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache -o -path /var/log \) -prune -o -print | sort
}

files >/tmp/before
apt-get update -qq
say "installing with what the packages depend on, and nothing else"
apt-get install -y -qq --no-install-recommends "$folder"/*.deb >/tmp/install.log 2>&1 ||
    { tail -n 30 /tmp/install.log >&2; fail "the packages cannot be installed"; }

say "$(contactd --version | head -n 2 | tr '\n' ' ')"
getent passwd contactd >/dev/null || fail "the user contactd was not made"
[ "$(stat -c %U:%a /var/lib/contactd)" = contactd:750 ] || fail "/var/lib/contactd is not the daemon's own"
[ "$(dpkg-query -W -f='${Conffiles}' contactd | grep -c /etc/contactd/contactd.json)" = 1 ] || fail "the configuration is no conffile"
# Starts the daemon like the unit: with its command line, its user and its folder.
command=$(sed -n 's/^ExecStart=//p' /usr/lib/systemd/system/contactd.service)
setpriv --reuid contactd --regid contactd --clear-groups $command --check-config

say "starting the daemon and solving"
cd /var/lib/contactd
# Uses its own socket, because the network is shared with the machine.
endpoint=ipc:///var/lib/contactd/socket
setpriv --reuid contactd --regid contactd --clear-groups $command --endpoint $endpoint >/tmp/ready 2>/tmp/daemon.log &
daemon=$!
trap 'kill $daemon 2>/dev/null || true' EXIT
tries=0
until [ -s /tmp/ready ]; do
    tries=$((tries + 1))
    [ $tries -lt 300 ] || { cat /tmp/daemon.log >&2; fail "the daemon did not start"; }
    sleep 0.1
done
cd /
contactd --ping $endpoint
PYTHONDONTWRITEBYTECODE=1 python3 "$folder/test_installed.py" $endpoint || { cat /tmp/daemon.log >&2; fail "the client failed"; }

say "asking from the command line"
[ "$(contactctl health --endpoint $endpoint)" = serving ] || fail "contactctl does not reach the daemon"
contactctl wheelrail geometry --Fz 80e3 --endpoint $endpoint --json | python3 -m json.tool >/dev/null || fail "contactctl failed"

say "solving in the process of Python"
PYTHONDONTWRITEBYTECODE=1 python3 "$folder/test_installed.py" local || fail "the client failed in process"

say "building a C program, with the client's library and with the one that solves in process"
apt-get install -y -qq --no-install-recommends gcc libc6-dev pkgconf >/tmp/gcc.log 2>&1 || fail "there is no compiler"
for place in contactd=$endpoint contactd-local=local; do
    cc -std=c99 -pedantic -Wall -Werror "$folder/cattaneo.c" $(pkg-config --cflags --libs "${place%%=*}") -o /tmp/cattaneo
    /tmp/cattaneo "${place#*=}" >>/tmp/cattaneo.out || { cat /tmp/daemon.log >&2; fail "the C program failed"; }
done
# Both print the same two lines.
[ "$(sort /tmp/cattaneo.out | uniq -c | awk '{ print $1 }' | xargs)" = "2 2" ] || fail "daemon and library differ"
cc -std=c99 -pedantic -Wall -Werror "$folder/creep_forces.c" $(pkg-config --cflags --libs contactd-cntc) -o /tmp/creep_forces
[ "$(/tmp/creep_forces | grep -c 'creepage 0.00')" = 4 ] || fail "the program by the cntc functions failed"
kill -TERM $daemon
wait $daemon || fail "the daemon ended with status $?"
trap - EXIT
[ -n "$(find /var/lib/contactd/store -name '*.h5')" ] || fail "the table was not kept"

say "removing and purging"
packages=$(dpkg-query -W -f='${Package}\n' | grep contactd)
apt-get remove -y -qq $packages >/tmp/remove.log 2>&1 || { cat /tmp/remove.log >&2; fail "removal failed"; }
[ -e /etc/contactd/contactd.json ] || fail "removal took the configuration"
[ -d /var/lib/contactd ] || fail "removal took the tables"
[ ! -e /usr/bin/contactd ] || fail "removal left the daemon"
# Uses dpkg, because apt no longer lists packages that were removed completely.
dpkg --purge $packages >/tmp/purge.log 2>&1 || { cat /tmp/purge.log >&2; fail "purging failed"; }
files >/tmp/after
left=$(comm -13 /tmp/before /tmp/after | grep -i contactd || true)
[ -z "$left" ] || fail "files left behind: $left"
! getent passwd contactd >/dev/null || fail "the user contactd was left behind"
say "all is well"

# Runs inside a bare root, from test_wheels.sh: bash use_wheels.sh. The wheels are in /srv/wheels, the tests in /srv,
# and all writable files in /home.
set -euo pipefail
export PYTHONDONTWRITEBYTECODE=1 PIP_NO_CACHE_DIR=1 PIP_NO_WARN_SCRIPT_LOCATION=1
here=/srv/packaging/wheels
say() { echo "wheel test: $*" >&2; }
fail() { say "$*"; exit 1; }
install() { "$1/bin/pip" install --quiet --find-links /srv/wheels "$2"; }
names() { "$1/bin/pip" list --format freeze | sed 's/=.*//' | sort; }
files() { find /home /tmp -not -path '*/__pycache__*' | sort; }

say "Debian $(cat /etc/debian_version), $(python3 --version), $(ldd --version | head -n 1)"
cd /home
python3 -m venv plain
touch /tmp/before /tmp/after
names plain >/tmp/names
files >/tmp/before

say "contactd[local], and nothing else: contactd.local() solves in process"
install plain "contactd[local]"
plain/bin/python "$here/try_local.py" || fail "contactd[local] does not work"
plain/bin/python "$here/import_time.py" >&2
listed=$(plain/bin/python -m contactd.examples)
grep -q '^cattaneo.py ' <<<"$listed" || fail "the examples are missing"
plain/bin/python -m contactd.examples examples >/dev/null
solved=$(plain/bin/python examples/cattaneo.py)
grep -q '^Fz 9.1973' <<<"$solved" || fail "an example does not work"
refused=$(plain/bin/python -m contactd.demo 2>&1 || true) # without matplotlib
grep -q 'pip install "contactd\[pictures\]"' <<<"$refused" || fail "the demo does not say what it lacks"
rm -r examples

say "contactd[local,daemon]: it also builds tables, in process and in a daemon"
install plain "contactd[local,daemon]"
plain/bin/python "$here/try_local.py" tables || fail "contactd[local,daemon] does not work"
for program in contactd contactd-ic; do
    plain/bin/$program --version >/dev/null || fail "$program does not start"
done

say "removing all of it leaves nothing"
names plain | comm -13 /tmp/names - | xargs plain/bin/pip uninstall --quiet --yes
files >/tmp/after
left=$(comm -13 /tmp/before /tmp/after)
[ -z "$left" ] || fail "files left behind: $left"
rm -r plain

say "the first steps of a stranger"
python3 "$here/first_steps.py" /srv/wheels /srv/docs/python.md /srv/support/contact_hertz.py >&2 ||
    fail "a first step failed"
rm -r first ./*.png x.inp x.out

say "the guide and the tutorials, as they are written"
python3 -m venv whole
install whole "contactd[all]"
whole/bin/python -m contactd.demo demo.png >&2
[ -s demo.png ] || fail "the demo draws nothing"
MPLBACKEND=Agg whole/bin/python "$here/test_guides.py" /srv/docs/python.md /srv/docs/tutorials/*.ipynb || fail "a guide failed"

say "the command line, as its page has it"
PATH="/home/whole/bin:$PATH" whole/bin/python "$here/try_contactctl.py" /srv/docs/contactctl.md || fail "contactctl failed"
say "all is well"

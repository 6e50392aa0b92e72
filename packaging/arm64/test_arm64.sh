#!/usr/bin/env bash
# packaging/arm64/test_arm64.sh BUILD CASES MACHINE: runs the programs of tests/platforms in BUILD/bin under QEMU, and
# compares their output with that of this machine in CASES/linux. Then it installs and uses the wheels of BUILD/wheels
# with the Python of MACHINE, a folder of arm64 files. QEMU runs one program only: this machine would run its child
# processes, so the tests start none.
set -euo pipefail

repository=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
cases_of=$repository/tests/platforms/platform_cases.py
build=$(realpath "$1")
cases=$(realpath "$2")
machine=$(realpath "$3")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
say() { echo "arm64 test: $*" >&2; }

say "$(qemu-aarch64 --version | head -n 1)"
for library in "$build"/lib/*.so.*.*.* "$build"/lib/fmu/*.so; do
    asked=$(aarch64-linux-gnu-readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | grep -vxE 'lib(c|m)\.so\.6|ld-linux-aarch64\.so\.1' || true)
    [ -z "$asked" ] || { say "$(basename "$library") asks for $asked"; exit 1; }
done

# Uses the store that this machine has filled.
rm -rf "$cases/arm64"
mkdir -p "$cases/arm64"
cp -r "$cases/linux/Tafeln für Räder" "$cases/linux/cases of "* "$cases/arm64/"
python3 "$cases_of" run "$build/bin" "$cases/fmus" "$build/lib/fmu/contactd_fmu.so" "$cases/arm64" qemu-aarch64

python_of_arm64() {
    PYTHONPATH=$scratch/site PYTHONDONTWRITEBYTECODE=1 HOME=$scratch MPLBACKEND=Agg qemu-aarch64 -L "$machine" "$machine/usr/bin/python3" "$@"
}
say "$(python_of_arm64 -c 'import platform; print(platform.machine(), platform.python_version(), *platform.libc_ver())'): installing contactd[local,pictures]"
python_of_arm64 -m pip install --quiet --no-compile --only-binary :all: --find-links "$build/wheels" --target "$scratch/site" "contactd[local,pictures]"
cd "$scratch"
python_of_arm64 "$repository/packaging/wheels/try_local.py" >&2
PYTHONPATH=$scratch/site HOME=$scratch python3 "$cases_of" python "$cases/linux" "$cases/arm64" qemu-aarch64 -L "$machine" "$machine/usr/bin/python3"
python3 "$cases_of" compare "$cases/linux" "$cases/arm64"
python_of_arm64 -m contactd.demo demo.png >&2
[ -s demo.png ] || { say "the demo draws nothing"; exit 1; }
say "all is well"

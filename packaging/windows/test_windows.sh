#!/usr/bin/env bash
# packaging/windows/test_windows.sh BUILD CASES MACHINE: runs the programs of tests/platforms in BUILD/lib under Wine,
# and compares their output with that of Linux in CASES/linux. The wheels of BUILD/wheels are installed and used with
# the Python of MACHINE.
set -euo pipefail

repository=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
cases_of=$repository/tests/platforms/platform_cases.py
build=$(realpath "$1")
cases=$(realpath "$2")
machine=$(realpath "$3")
scratch=$(mktemp -d)
trap 'WINEPREFIX=$scratch/prefix /usr/lib/wine/wineserver64 -k 2>/dev/null || true; rm -rf "$scratch"' EXIT
export WINEPREFIX=$scratch/prefix WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml=" HOME=$scratch DISPLAY=
say() { echo "windows test: $*" >&2; }

say "$(/usr/lib/wine/wine64 --version), $(ls "$build"/lib/*.dll | wc -l) DLLs"
for dll in "$build"/lib/*.dll "$build"/lib/{fmu/*.dll,python/*.pyd}; do
    asked=$(x86_64-w64-mingw32ucrt-objdump -p "$dll" | sed -n 's/.*DLL Name: //p' | grep -viE '^(python3|kernel32|bcrypt|shell32|advapi32|shlwapi|api-ms-win-crt-[a-z]+-l1-1-0)\.dll$' || true)
    [ -z "$asked" ] || { say "$(basename "$dll") asks for $asked, which Windows has not"; exit 1; }
done

# Uses the store filled by Linux, at a path with blanks and umlauts.
rm -rf "$cases/windows"
mkdir -p "$cases/windows"
cp -r "$cases/linux/Tafeln für Räder" "$cases/linux/cases of "* "$cases/windows/"
python3 "$cases_of" run "$build/lib" "$cases/fmus" "$build/lib/fmu/contactd_fmu.dll" "$cases/windows" /usr/lib/wine/wine64

# By pip's rules for Windows, name and metadata of the wheel state where it runs.
site=$scratch/site
cp -r "$machine/site" "$site"
python3 -m venv "$scratch/venv"
"$scratch/venv/bin/pip" install --quiet --no-index --no-deps --no-compile --find-links "$build/wheels" --target "$scratch/installed" \
    --only-binary :all: --platform win_amd64 --python-version 3.13 --implementation cp --abi cp313 --abi abi3 --abi none contactd contactd-local
cp -r "$scratch"/installed/* "$site/"
export PYTHONPATH="Z:${site//\//\\}"
say "$(/usr/lib/wine/wine64 "$machine/python/python.exe" -c 'import platform; print(platform.platform(), platform.python_version())' | tr -d '\r')"
/usr/lib/wine/wine64 "$machine/python/python.exe" "$repository/packaging/wheels/try_local.py" >&2
python3 "$cases_of" python "$cases/linux" "$cases/windows" /usr/lib/wine/wine64 "$machine/python/python.exe"
unset PYTHONPATH

python3 "$cases_of" compare "$cases/linux" "$cases/windows"
say "all is well"

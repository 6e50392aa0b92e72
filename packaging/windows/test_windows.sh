#!/usr/bin/env bash
# packaging/windows/test_windows.sh BUILD CASES: runs the programs of tests/platforms of BUILD/lib under Wine, and compares their lines
# with those of Linux, which are in CASES/linux.
set -euo pipefail

cases_of=$(dirname "$(readlink -f "$0")")/../../tests/platforms/platform_cases.py
build=$(realpath "$1")
cases=$(realpath "$2")
scratch=$(mktemp -d)
trap 'WINEPREFIX=$scratch/prefix /usr/lib/wine/wineserver64 -k 2>/dev/null || true; rm -rf "$scratch"' EXIT
export WINEPREFIX=$scratch/prefix WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml=" HOME=$scratch DISPLAY=
say() { echo "windows test: $*" >&2; }

say "$(/usr/lib/wine/wine64 --version), $(ls "$build"/lib/*.dll | wc -l) DLLs"
for dll in "$build"/lib/*.dll "$build"/lib/fmu/*.dll; do
    asked=$(x86_64-w64-mingw32ucrt-objdump -p "$dll" | sed -n 's/.*DLL Name: //p' | grep -viE '^(kernel32|bcrypt|shell32|advapi32|shlwapi|api-ms-win-crt-[a-z]+-l1-1-0)\.dll$' || true)
    [ -z "$asked" ] || { say "$(basename "$dll") asks for $asked, which Windows has not"; exit 1; }
done

# The store that Linux has filled, at a path of blanks and umlauts.
rm -rf "$cases/windows"
mkdir -p "$cases/windows"
cp -r "$cases/linux/Tafeln für Räder" "$cases/linux/cases of "* "$cases/windows/"
python3 "$cases_of" run "$build/lib" "$cases/fmus" "$build/lib/fmu/contactd_fmu.dll" "$cases/windows" /usr/lib/wine/wine64
python3 "$cases_of" compare "$cases/linux" "$cases/windows"
say "all is well"

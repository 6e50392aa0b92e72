#!/usr/bin/env bash
# packaging/wheel.sh FOLDER [BIN]: the wheel of the Python client in FOLDER; with BIN, the folder of contactd, it is
# installed in an empty environment, the examples of docs/python.md run there, and it is removed again.
set -euo pipefail

repository=$(dirname "$(dirname "$(readlink -f "$0")")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH

say() { printf 'wheel: %s\n' "$*" >&2; }

# setuptools writes beside the sources, which stay as they are.
cp -r "$repository/client/python" "$scratch/sources"
rm -rf "$scratch/sources/build" # of an earlier one, which would be taken for the sources
cp "$repository/LICENSE" "$scratch/sources/"
python3 -m venv "$scratch/tools"
mkdir -p "$folder"
rm -f "$folder"/contactd-*.whl
"$scratch/tools/bin/pip" wheel --quiet --no-deps --wheel-dir "$folder" "$scratch/sources"
wheel=$(ls "$folder"/contactd-*-py3-none-any.whl)
[ $# -gt 1 ] || { say "$wheel" && exit; }

python3 -m venv "$scratch/empty"
"$scratch/empty/bin/pip" freeze --all | sort >"$scratch/before"
"$scratch/empty/bin/pip" install --quiet "$wheel"
cd "$scratch"
empty/bin/python -c "import contactd; print('wheel: contactd', contactd.__version__, 'in', contactd.__path__[0])" >&2
empty/bin/pip install --quiet "$wheel[hdf5,pictures,progress,xarray]"
MPLBACKEND=Agg PATH="$2:$PATH" empty/bin/python "$repository/packaging/test_wheel.py" "$repository/docs/python.md"
empty/bin/pip uninstall --quiet --yes contactd
left=$(find empty -name '*contactd*' | head -3)
[ -z "$left" ] || { say "uninstalling has left $left" && exit 1; }
say "all is well: $wheel"

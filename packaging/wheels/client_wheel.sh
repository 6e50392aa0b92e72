#!/usr/bin/env bash
# packaging/wheels/client_wheel.sh FOLDER: contactd, the wheel of the Python client and of contactctl, in FOLDER.
set -euo pipefail

repository=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH

# setuptools writes beside the sources, which stay as they are.
cp -r "$repository/client/python" "$scratch/sources"
rm -rf "$scratch/sources/build" # of an earlier one, which would be taken for the sources
cp "$repository/LICENSE" "$scratch/sources/"
python3 -m venv "$scratch/tools"
mkdir -p "$folder"
rm -f "$folder"/contactd-*.whl
"$scratch/tools/bin/pip" wheel --quiet --no-deps --wheel-dir "$folder" "$scratch/sources"
ls "$folder"/contactd-*-py3-none-any.whl

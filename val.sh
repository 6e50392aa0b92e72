#!/bin/bash
# usage: val.sh OUT [families]
cd /work/h/reference
o=$1; mkdir -p build/val/$o
only=${2:+--only $2}
./dev shell bash -c "PATH=$PWD/build/development/bin:\$PATH PYTHONPATH=$PWD/bench:$PWD/client/python:$PWD/build/development/lib/python python3 -m validation --bin build/development/bin $only --output build/val/$o/validation"

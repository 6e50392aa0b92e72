#!/bin/sh
# Starts the program of this name with its own loader and libraries, independent of the machine's. The loader lies
# beside this file, so the program finds its folder here (/proc/self/exe), with the builder and the modules.
here=$(dirname "$(readlink -f "$0")")
exec "$here/LOADER" --inhibit-cache --library-path "$here/../lib" --argv0 "$0" "$here/../programs/NAME" "$@"

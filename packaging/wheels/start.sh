#!/bin/sh
# Starts the program of this name with its own loader and libraries, whatever the machine has. The loader lies beside this
# file: what the program takes for its own folder (/proc/self/exe) is this one, with the builder and modules in it.
here=$(dirname "$(readlink -f "$0")")
exec "$here/LOADER" --inhibit-cache --library-path "$here/../lib" --argv0 "$0" "$here/../programs/NAME" "$@"

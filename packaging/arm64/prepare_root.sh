# Runs inside the root that ./dev arm64 makes, before the packages come: MPI's headers of arm64 ask for a Fortran compiler that runs
# there, and would bring it, and those of C and C++, in place of the ones that run here. Nothing here is compiled by it.
set -eu
folder=$(mktemp -d)
mkdir "$folder/DEBIAN"
cat >"$folder/DEBIAN/control" <<'END'
Package: contactd-without-fortran
Version: 1
Architecture: all
Multi-Arch: foreign
Maintainer: contactd authors <contactd@example.org>
Provides: gfortran-mod-15
Description: stands for a Fortran compiler of arm64
END
dpkg-deb --build "$folder" "$folder.deb" >/dev/null
dpkg --install "$folder.deb" >/dev/null
rm -r "$folder" "$folder.deb"

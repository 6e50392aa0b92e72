"""Assembles a release from the built parts: python3 packaging/release check VERSION, or assemble VERSION FOLDER.

check lists the reasons why this clone cannot be released. assemble takes wheels, packages, libraries, FMUs and the
site from the build folder, and makes the archives, the bill of materials, the notices and the checksums. ./dev release
signs them.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from datetime import datetime, timezone
from pathlib import Path

from archives import epoch, files_of, write_tar, write_zip
from places import telling
from sbom import bill_of
from versions import ROOT, differing, version

BUILD = ROOT / "build"


def git(*arguments: str) -> bytes:
    return subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, check=True).stdout


def reasons_against(asked: str) -> list[str]:
    """Returns the reasons why this clone is not a release of that version."""
    wrong = [f"{sentence}; it must be {version()}" for sentence in differing()]
    if asked != version():
        wrong.append(f"CMakeLists.txt has {version()}; packaging/release/versions.py {asked} changes it in all places")
    if changed := git("status", "--porcelain").decode().splitlines():
        wrong.append(f"the tree is not clean: {changed[0].strip()}, {len(changed)} in all")
    tag = f"v{asked}"
    if tag not in git("tag", "--points-at", "HEAD").decode().split():
        wrong.append(f"HEAD has no tag {tag}")
    return wrong


def assemble(asked: str, folder: Path) -> None:
    folder.mkdir(parents=True)
    for kind in ("wheels/*.whl", "package/packages/*.deb", "fmu/*.fmu", "fmu/*.ssp", "arm64/wheels/*_aarch64.whl", "windows/wheels/*-win_amd64.whl", "arm64-package/packages/*_arm64.deb"):
        files = sorted(BUILD.glob(kind))
        if not files:
            sys.exit(f"build/{kind} is missing")
        for file in files:
            shutil.copyfile(file, folder / file.name)
    name = f"contactd-{asked}"
    sources = tarfile_of(git("archive", "--format=tar", "HEAD"))
    write_tar(folder / f"{name}-source.tar.gz", {f"{name}/{file}": data for file, data in sources.items()})
    sdist(folder, sources)
    headers = {f"include/{file}": sources[f"client/{place}/include/{file}"] for place, file in (("c", "contactd.h"), ("c/generated", "contactd/paths.h"), ("cntc", "contactd_cntc.h"))}
    pages = {"LICENSE": sources["LICENSE"], "README.md": sources["packaging/release/LIBRARIES.md"]}
    examples = {f"examples/{Path(file).name}": data for file, data in sources.items() if file.startswith(("client/c/example/", "client/c/fortran/", "client/cntc/example/"))}
    inside = notices_of(folder)
    libraries = {f"lib/{path.name}": path.read_bytes() for path in sorted((BUILD / "windows" / "lib").iterdir()) if path.suffix in (".dll", ".a", ".def") and "fmu" not in path.name}
    windows, arm64 = (files_of(BUILD / platform / "notices") for platform in ("windows", "arm64"))
    write_zip(folder / f"{name}-windows-x86_64.zip", {f"{name}/{file}": data for file, data in {**headers, **pages, **examples, **libraries, **windows}.items()})
    linux = {"SOURCES.txt": inside["sources.txt"], **{f"licenses/{file}": data for file, data in inside.items() if file != "sources.txt"}}
    for machine, built, texts in (("x86_64", "fmu-build", linux), ("aarch64", "arm64", arm64)):
        found = sorted((BUILD / built / "lib").glob("libcontactd-*.so*"))
        shared = {f"lib/{path.name}": path.read_bytes() for path in found if not path.is_symlink()}
        # Creates the names by which linkers find the libraries, and programs when they start.
        links = {f"{name}/lib/{path.name}": os.readlink(path) for path in found if path.is_symlink()}
        if not shared:
            sys.exit(f"build/{built}/lib has no libraries")
        write_tar(folder / f"{name}-linux-{machine}.tar.gz", {f"{name}/{file}": data for file, data in {**headers, **pages, **examples, **shared, **texts}.items()}, links)
    site = files_of(BUILD / "docs", f"{name}-site/")
    site.pop(f"{name}-site/.buildinfo", None)  # a digest of paths that only Sphinx uses, for rebuilds
    write_tar(folder / f"{name}-site.tar.gz", site)
    notices = {**inside, **{Path(file).name: data for file, data in {**windows, **arm64}.items() if file.startswith("licenses/")}}
    (folder / "NOTICES.txt").write_bytes(b"\n".join(f"=== {file} ===\n".encode() + notices[file] for file in sorted(notices)))
    shutil.copyfile(ROOT / "packaging" / "release" / "check.py", folder / "check.py")
    moment = datetime.fromtimestamp(epoch(), timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    (folder / f"{name}.cdx.json").write_text(bill_of(folder, asked, moment))
    own = [f"{ROOT}/", f"{Path(tempfile.gettempdir(), 'tmp.')}", *(f"{os.environ[name]}/" for name in ("HOME", "XDG_CACHE_HOME") if os.environ.get(name))]
    if named := telling(folder, own):
        sys.exit("\n".join(["files would be others where this clone, its user or temporary folders have other names:", *named]))
    sums = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(folder.iterdir())]
    (folder / "SHA256SUMS").write_text("".join(sums))


def tarfile_of(content: bytes) -> dict[str, bytes]:
    with tempfile.TemporaryFile() as file:
        file.write(content)
        file.seek(0)
        with tarfile.open(fileobj=file) as archive:
            return {member.name: found.read() for member in archive if (found := archive.extractfile(member)) is not None}


def sdist(folder: Path, sources: dict[str, bytes]) -> None:
    """Repacks the source distribution of the client."""
    with tempfile.TemporaryDirectory() as scratch:
        project = Path(scratch, "project")
        for file, data in sources.items():
            if file.startswith("client/python/") or file == "LICENSE":
                place = project / file.removeprefix("client/python/")
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_bytes(data)
        build = "import sys; from setuptools.build_meta import build_sdist; print(build_sdist(sys.argv[1]))"
        made = subprocess.run([sys.executable, "-c", build, scratch], cwd=project, stdout=subprocess.PIPE, text=True, check=True)
        archive = Path(scratch, made.stdout.splitlines()[-1])
        with tarfile.open(archive) as opened:
            files = {member.name: found.read() for member in opened if (found := opened.extractfile(member)) is not None}
        write_tar(folder / archive.name, files)


def notices_of(folder: Path) -> dict[str, bytes]:
    """Returns the notices in FMUs for Linux, which also apply to the libraries."""
    with zipfile.ZipFile(next(folder.glob("*.fmu"))) as archive:
        place = "documentation/licenses/"
        found = {name.removeprefix(place): archive.read(name) for name in archive.namelist() if name.startswith(place)}
    return {name: text for name, text in found.items() if "/" not in name}  # deeper ones are those of other platforms


def main() -> None:
    parser = argparse.ArgumentParser(prog="release", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    does = parser.add_subparsers(dest="does", required=True)
    checking, assembling = does.add_parser("check"), does.add_parser("assemble")
    for one in (checking, assembling):
        one.add_argument("version")
    assembling.add_argument("folder", type=Path)
    options = parser.parse_args()
    if options.does == "check":
        reasons = reasons_against(options.version)
        print("\n".join(reasons), end="\n" if reasons else "", file=sys.stderr)
        sys.exit(1 if reasons else 0)
    assemble(options.version, options.folder)


if __name__ == "__main__":
    main()

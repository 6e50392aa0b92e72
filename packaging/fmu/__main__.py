"""Makes the FMUs: python3 packaging/fmu DESCRIBER LIBRARY FOLDER [--complete STATIC ...] [--windows FOLDER] [--arm64
FOLDER].

DESCRIBER is contactd-fmu-description, and LIBRARY the shared object of all FMUs. FOLDER receives an archive for each
kind and version of FMI: contactd_contact_fmi2.fmu, ... With --complete, the library must depend on the C library only,
and the licences of its contents are added. STATIC are the folders made by packaging/wheels/static_libraries.sh,
zeromq.sh and packaging/ducc0/fetch.sh. With --windows, the archives also contain the DLL that ./dev windows has put
into FOLDER/lib/fmu, with its licences. With --arm64, they contain the library of ./dev arm64 if the version of FMI has
a folder for it. FMI 2 supports one processor of Linux only, so separate archives are made for arm64:
contactd_contact_fmi2_arm64.fmu, ... ./dev fmu does all of this.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from archive import write_fmu
from model_description import model_description

sys.path.append(str(Path(__file__).parents[1] / "wheels"))
from inside import licenses_of, origins_of, refuse_links

ROOT = Path(__file__).parents[2]
#: Maps versions of FMI to the folders of the shared object.
PLATFORMS = {2: "linux64", 3: "x86_64-linux"}
OF_WINDOWS = {2: "win64", 3: "x86_64-windows"}
OF_ARM64 = {3: "aarch64-linux"}


def main() -> None:
    parser = argparse.ArgumentParser(prog="fmu", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("describer", type=Path)
    parser.add_argument("library", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--complete", type=Path, metavar="STATIC", nargs="+")
    parser.add_argument("--windows", type=Path, metavar="FOLDER")
    parser.add_argument("--arm64", type=Path, metavar="FOLDER")
    options = parser.parse_args()

    described = json.loads(subprocess.run([options.describer.resolve()], capture_output=True, check=True).stdout)
    licenses = {"contactd.txt": (ROOT / "LICENSE").read_text()}
    if options.complete:
        refuse_links(options.library)
        sources = origins_of(options.library).sources()
        for static in options.complete:
            licenses |= licenses_of(options.library, static)
            sources += (static / "sources.txt").read_text().splitlines()
        licenses["sources.txt"] = "\n".join(sources) + "\n"
    options.folder.mkdir(parents=True, exist_ok=True)
    library = stripped(options.library)
    dll = of_arm64 = None
    if options.windows:
        dll = (options.windows / "lib" / "fmu" / "contactd_fmu.dll").read_bytes()
        licenses |= notices_of("windows", options.windows)
    if options.arm64:
        of_arm64 = (options.arm64 / "lib" / "fmu" / "contactd_fmu.so").read_bytes()
        licenses |= notices_of("arm64", options.arm64)
    for kind in described["kinds"]:
        for fmi, platform in PLATFORMS.items():
            description = model_description(kind, described["units"], described["version"], fmi)
            files = {
                "modelDescription.xml": description,
                "resources/README.txt": b"Profiles that a parameter names without a folder are looked for here.\n",
                "documentation/index.html": page_of(kind),
                **{f"documentation/licenses/{name}": text.encode() for name, text in licenses.items()},
            }
            binaries = {f"binaries/{platform}/{kind['name']}.so": library}
            if dll:
                binaries[f"binaries/{OF_WINDOWS[fmi]}/{kind['name']}.dll"] = dll
            if of_arm64 and fmi in OF_ARM64:
                binaries[f"binaries/{OF_ARM64[fmi]}/{kind['name']}.so"] = of_arm64
            print(write_fmu(options.folder / f"{kind['name']}_fmi{fmi}.fmu", {**files, **binaries}))
            if of_arm64 and fmi not in OF_ARM64:
                alone = {f"binaries/{platform}/{kind['name']}.so": of_arm64}
                print(write_fmu(options.folder / f"{kind['name']}_fmi{fmi}_arm64.fmu", {**files, **alone}))


def notices_of(platform: str, folder: Path) -> dict[str, str]:
    """Returns the licences of a library of another platform, from the folder in which ./dev has built it."""
    notices = folder / "notices"
    texts = {f"{platform}/{file.name}": file.read_text(errors="replace") for file in sorted((notices / "licenses").iterdir())}
    return {**texts, f"{platform}/sources.txt": (notices / "SOURCES.txt").read_text()}


def stripped(library: Path) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["strip", "-o", f"{folder}/stripped", library], check=True)
        return Path(folder, "stripped").read_bytes()


def page_of(kind: dict) -> bytes:
    says = f"{kind['name']}: {kind['says']}. docs/fmu.md of contactd has the rest."
    return (
        f"<!DOCTYPE html>\n<html><head><title>{kind['name']}</title></head><body><p>{says}</p></body></html>\n".encode()
    )


if __name__ == "__main__":
    main()

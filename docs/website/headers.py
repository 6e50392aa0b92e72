"""Prepares comments of the public headers: doxygen reads them, and breathe puts them into pages."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
C_HEADER = ROOT / "client" / "c" / "include" / "contactd.h"
CLIENT_HEADERS = ROOT / "client" / "cpp" / "include"
CORE_HEADERS = ROOT / "core" / "include"
CASES_HEADERS = ROOT / "cases" / "include"


def public_headers() -> list[str]:
    """Returns the headers that a program in C++ may include: those of the client, and those that CMake offers of core and cases."""
    lists = "".join((ROOT / folder / "CMakeLists.txt").read_text() for folder in ("core", "cases"))
    offered = re.findall(r"target_sources\(contactd_\w+ PUBLIC FILE_SET.*?\)", lists, re.DOTALL)
    assert len(offered) == 2
    types = re.findall(r"include/(contactd/\w+\.hpp)", "".join(offered))
    return [*sorted(str(path.relative_to(CLIENT_HEADERS)) for path in CLIENT_HEADERS.rglob("*.hpp")), *types]


def path_of(header: str) -> Path:
    return next(folder / header for folder in (CLIENT_HEADERS, CORE_HEADERS, CASES_HEADERS) if (folder / header).exists())


def read_headers(work: Path) -> None:
    """Writes c/xml and cpp/xml into `work`."""
    _doxygen(work / "c", [C_HEADER], INPUT_FILTER=f'"{sys.executable} {FOLDER / "c_header.py"}"', PREDEFINED="CONTACTD_API=")
    _name_enums(work / "c" / "xml" / "contactd_8h.xml")
    _doxygen(work / "cpp", map(path_of, public_headers()), STRIP_FROM_PATH=f"{CLIENT_HEADERS} {CORE_HEADERS} {CASES_HEADERS}")
    _put_members_to_files(work / "cpp" / "xml")


def _doxygen(output: Path, files: Iterable[Path], **more: str) -> None:
    output.mkdir(parents=True)
    settings = {
        "INPUT": " ".join(map(str, files)),
        "OUTPUT_DIRECTORY": str(output),
        "GENERATE_XML": "YES",
        "GENERATE_HTML": "NO",
        "GENERATE_LATEX": "NO",
        "EXTRACT_ALL": "YES",
        "AUTOLINK_SUPPORT": "NO",
        "MACRO_EXPANSION": "YES",
        "EXPAND_ONLY_PREDEF": "YES",
        "QUIET": "YES",
        "WARN_AS_ERROR": "FAIL_ON_WARNINGS",
        **more,
    }
    text = "".join(f"{name} = {value}\n" for name, value in settings.items())
    subprocess.run(["doxygen", "-"], input=text, text=True, check=True)


def _name_enums(file: Path) -> None:
    """Sphinx accepts no enum without a name, and shows a name that begins with @ as anonymous."""
    count = iter(range(1000))
    file.write_text(re.sub("<name></name>", lambda _: f"<name>@{next(count)}</name>", file.read_text()))


def _put_members_to_files(folder: Path) -> None:
    """Doxygen lists functions and enums by namespaces; a page lists them by headers."""
    members = [
        (section.get("kind", ""), member)
        for file in sorted(folder.glob("namespace*.xml"))
        for section in ElementTree.parse(file).iter("sectiondef")
        for member in section.iter("memberdef")
    ]
    for file in folder.glob("*_8hpp.xml"):
        tree = ElementTree.parse(file)
        (compound,) = tree.iter("compounddef")
        for inner in [*compound.findall("innernamespace"), *filter(_is_nested, compound.findall("innerclass"))]:
            compound.remove(inner)
        here = compound.find("location")
        assert here is not None
        for kind, member in members:
            location = member.find("location")
            if location is not None and location.get("file") == here.get("file"):
                section = ElementTree.SubElement(compound, "sectiondef", kind=kind)
                name, full = member.find("name"), member.findtext("qualifiedname")
                if name is not None and full:
                    name.text = full
                section.append(member)
        tree.write(file, encoding="utf-8")


def _is_nested(inner: ElementTree.Element) -> bool:
    """It is shown with its class."""
    return bool(re.search(r"::[A-Z]\w*::", inner.text or ""))

"""Tests that every #include follows an arrow between folders in arrows.txt."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

import pytest

ROOT = Path(__file__).parents[2]
LIST = Path(__file__).with_name("arrows.txt")
TARGETS = ("core", "cases", "proto", "engine", "client/c", "client/cpp", "client/cntc", "client/fmu", "client/python/local", "server")
#: Lists folders in which #include "..." is searched, in addition to the folder of the file itself.
PLACES = ("core/include", "core/types/generated/include", "core/src", "core/fem", "core", "cases/include", "cases", "", "proto/include", "proto/src", "client/c/include", "client/c/src", "client/cpp/include", "client/cpp/src", "client/cntc/include", "client/cntc/src", "client/fmu", "server/src", "server/contactd_ic")  # fmt: skip
PUBLIC = ("core/include/contactd/", "cases/include/contactd/")


@dataclass
class Arrows:
    """What arrows.txt says."""

    direct: dict[str, list[str]] = field(default_factory=dict)  # maps a folder to the folders after its arrow
    headers: dict[str, str] = field(default_factory=dict)  # maps a public header without a source to its folder
    libraries: dict[str, list[str]] = field(default_factory=dict)  # maps the beginning of an #include to folders
    debts: set[tuple[str, str]] = field(default_factory=set)  # a file, and its forbidden include

    @classmethod
    def read(cls, text: str) -> Arrows:
        arrows = cls()
        for line in filter(None, (line.partition("#")[0].strip() for line in text.splitlines())):
            match re.split(r" (->|is in|only in|still includes) ?", line, maxsplit=1):
                case [folder, "->", others]:
                    assert folder not in arrows.direct, f"{folder} has two lines"
                    arrows.direct[folder] = others.split()
                case [header, "is in", folder]:
                    arrows.headers[header] = folder
                case [library, "only in", folders]:
                    arrows.libraries[library] = folders.split()
                case [file, "still includes", other]:
                    arrows.debts.add((file, other))
                case _:
                    raise ValueError(f"{LIST.name} has the line {line!r}")
        return arrows

    def folder_of(self, file: str) -> str | None:
        if file.startswith(PUBLIC):
            file = f"{self.headers[file]}/header" if file in self.headers else source_of(file)
        return next((str(above) for above in PurePosixPath(file).parents if str(above) in self.direct), None)

    def reach(self, folder: str) -> set[str]:
        """Returns the folders that arrows lead to from this one, and itself. Raises if they form a cycle."""
        reached, open_ends = {folder}, list(self.direct[folder])
        while open_ends:
            end = open_ends.pop()
            below = [other for other in self.direct if f"{other}/".startswith(f"{end}/")]
            assert below, f"an arrow leads to {end}, which has no line"
            assert folder not in below, f"arrows lead from {folder} back to it"
            open_ends += [other for known in set(below) - reached for other in self.direct[known]]
            reached.update(below)
        return reached


def source_of(header: str) -> str:
    """Returns the source with the name of a public header; "" if there is none."""
    name = Path(header).with_suffix(".cpp").name
    folders = ("core/types", "core/profile_files", "core/src", "core/fem", "cases")
    found = [path for folder in folders for path in (ROOT / folder).rglob(name) if path.parent.name != "generated"]
    return found[0].relative_to(ROOT).as_posix() if len(found) == 1 else ""


def sources() -> list[str]:
    return sorted(path.relative_to(ROOT).as_posix() for target in TARGETS for path in (ROOT / target).rglob("*.[ch]pp"))


def includes(file: str, opening: str, closing: str) -> list[str]:
    return re.findall(rf"^\s*#\s*include {opening}([^{closing}]+){closing}", (ROOT / file).read_text(), re.MULTILINE)


def own_includes(file: str) -> Iterator[str]:
    """Returns the project's files that `file` includes."""
    for name in includes(file, '"', '"'):
        places = [(ROOT / file).parent, *(ROOT / place for place in PLACES)]
        if found := next((place / name for place in places if (place / name).is_file()), None):
            yield found.resolve().relative_to(ROOT).as_posix()


def against(arrows: Arrows) -> dict[tuple[str, str], str]:
    """Returns includes without an arrow, as pairs of files, and the errors in them."""
    wrong = {}
    for file in sources():
        start = arrows.folder_of(file)
        assert start, f"{file} lies in no folder of {LIST.name}"
        allowed = arrows.reach(start)
        for other in own_includes(file):
            if (end := arrows.folder_of(other)) not in allowed:
                wrong[file, other] = f"{file} includes {other}: no arrow leads from {start} to {end}"
    return wrong


def outside(arrows: Arrows) -> list[str]:
    """Returns includes of libraries in places where they are not allowed."""
    return [
        f"{file} includes <{name}>, which is for {' and '.join(folders)} only"
        for file in sources()
        for name in includes(file, "<", ">")
        for library, folders in arrows.libraries.items()
        if f"<{name}>".startswith(library) and not any(file.startswith(f"{folder}/") for folder in folders)
    ]


@pytest.fixture
def arrows() -> Arrows:
    return Arrows.read(LIST.read_text())


def test_every_include_goes_along_an_arrow(arrows: Arrows) -> None:
    assert len(sources()) > 300
    wrong = against(arrows)
    assert [sentence for pair, sentence in wrong.items() if pair not in arrows.debts] == []
    assert arrows.debts - wrong.keys() == set(), "paid: take these lines out of arrows.txt"


def test_no_two_folders_at_the_top_include_from_each_other() -> None:
    tops = {(file.split("/")[0], other.split("/")[0]) for file in sources() for other in own_includes(file)}
    arrows = Arrows({top: sorted(other for one, other in tops if one == top != other) for top in {one for one, _ in tops}})
    for top in arrows.direct:
        arrows.reach(top)  # raises if there is a cycle
    assert arrows.reach("core") == {"core"}


def test_libraries_are_included_where_they_belong_only(arrows: Arrows) -> None:
    assert outside(arrows) == []


def test_every_folder_of_the_list_exists_and_no_arrow_leads_back(arrows: Arrows) -> None:
    for folder in arrows.direct:
        assert (ROOT / folder).is_dir(), folder
        arrows.reach(folder)
    assert all((ROOT / header).is_file() and not source_of(header) for header in arrows.headers)


def test_the_page_about_the_architecture_names_every_folder(arrows: Arrows) -> None:
    page = (ROOT / "docs" / "architecture.md").read_text()
    unnamed = [folder for folder in arrows.direct if not re.search(rf"[`/]{PurePosixPath(folder).name}[`/]", page)]
    assert unnamed == []


def test_a_reversed_arrow_is_found(arrows: Arrows) -> None:
    arrows.direct["core/src/operators"].append("core/src/bodies")
    arrows.direct["core/src/bodies"].remove("core/src/operators")
    wrong = " ".join(against(arrows).values())
    assert "no arrow leads from core/src/bodies to core/src/operators" in wrong


def test_a_library_in_another_folder_is_found(arrows: Arrows) -> None:
    arrows.libraries["<mfem.hpp>"] = ["core/src"]
    assert all("core/fem" in line and "<mfem.hpp>" in line for line in outside(arrows))
    assert outside(arrows)


@pytest.mark.parametrize(
    "text", ["a", "a -> b", "a -> a", "a -> b\nb -> a", "a -> b\nb -> c\nc -> a\nd ->", "a ->\na ->"]
)
def test_a_list_that_makes_no_sense_is_refused(text: str) -> None:
    with pytest.raises((AssertionError, ValueError)):
        arrows = Arrows.read(text)
        for folder in arrows.direct:
            arrows.reach(folder)

"""docs/cntc.md says of each function of the header what is covered, and its example is the one that is run. Flags are
there or in docs/contact-conventions.md."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "cntc.md").read_text()
HEADER = (ROOT / "client" / "cntc" / "include" / "contactd_cntc.h").read_text()


def declared() -> set[str]:
    code = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)
    return set(re.findall(r"\bvoid ((?:cntc|subs)_\w+)\(", code))


def names(text: str) -> list[str]:
    return re.findall(r"`((?:cntc|subs)_\w+)`", text)


def listed() -> dict[str, list[str]]:
    functions = PAGE.split("## Functions")[1].split("## Flags")[0]
    tables, not_covered = functions.split("### Not covered")
    result: dict[str, list[str]] = {"covered": [], "partly": [], "not": names(not_covered.replace("`cntc_calculate`", ""))}
    for line in tables.splitlines():
        if row := re.match(r"\| (`.*`) \| (covered|partly) \|", line):
            result[row[2]] += names(row[1])
    return result


def test_every_function_of_the_header_is_listed_once() -> None:
    everything = [name for part in listed().values() for name in part]
    assert len(declared()) == 70
    assert sorted(everything) == sorted(declared())


def test_the_page_counts_right() -> None:
    counts = re.search(r"\| names \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|", PAGE)
    assert counts
    expected = [len(part) for part in listed().values()]
    assert [int(count) for count in counts.groups()] == [*expected, sum(expected)]


def test_the_example_of_the_page_is_the_program() -> None:
    program = (ROOT / "client" / "cntc" / "example" / "creep_forces.c").read_text()
    assert f"```c\n{program}```" in PAGE


def test_every_flag_is_on_a_page() -> None:
    codes = (ROOT / "client" / "cntc" / "src" / "edge" / "codes.hpp").read_text().split("namespace flag {")[1].split("}")[0]
    flags = set(re.findall(r" = (\d{4});", codes))
    assert len(flags) > 15
    pages = PAGE.split("## Flags")[1] + (ROOT / "docs" / "contact-conventions.md").read_text()
    assert not flags - set(re.findall(r"\b\d{4}\b", pages))

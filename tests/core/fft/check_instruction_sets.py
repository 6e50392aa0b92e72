"""The transforms for processors with AVX2 share no function with the rest of the program: python3 check_instruction_sets.py
OBJECT... Of functions that several objects may have, the linker keeps one, whichever instructions it is made of."""

import re
import subprocess
import sys
from pathlib import Path

#: Where what is compiled for AVX2 may lie: in a namespace of its own, and behind the function that makes it.
OWN = ("contactd_four_lanes", "contactd::make_four_lanes")
AVX = re.compile(
    r"v(mov|add|sub|mul|fm|fnm|perm|xor|zeroupper|broadcast|unpck|shuf|insert|extract|cvt|and|or|cmp|pxor)"
)


def output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def shared_names(file: Path) -> set[str]:
    """Mangled names of functions that other objects could share."""
    symbols = (line.split() for line in output("nm", "--defined-only", str(file)).splitlines())
    return {words[2] for words in symbols if len(words) == 3 and words[1] in "TWVu"}


def names_with_avx(file: Path) -> set[str]:
    found, name = set(), ""
    for line in output("objdump", "-d", "--no-show-raw-insn", str(file)).splitlines():
        if heading := re.match(r"[0-9a-f]+ <(.*)>:$", line):
            name = heading[1]
        elif (instruction := re.match(r"\s+[0-9a-f]+:\s+(\S+)", line)) and AVX.match(instruction[1]):
            found.add(name)
    return found


def plain(names: set[str]) -> set[str]:
    return set(output("c++filt", *sorted(names)).splitlines()) if names else set()


def main(files: list[str]) -> None:
    objects = {Path(file).name: Path(file) for file in files if re.search(r"/fft/lanes_\w+\.cpp\.o$", file)}
    four, two = objects["lanes_avx2.cpp.o"], objects["lanes_baseline.cpp.o"]
    with_avx = names_with_avx(four)
    if len(with_avx) < 20:
        sys.exit(f"{four} has {len(with_avx)} functions with AVX2: is it compiled for it?")
    wrong = sorted(
        name
        for name in plain(with_avx & shared_names(four))
        if not name.startswith(OWN) and not any(f" {own}" in name for own in OWN)
    )
    if wrong:
        sys.exit(
            f"{four} has functions of others with AVX2, which processors without it could meet:\n" + "\n".join(wrong)
        )
    if baseline := plain(names_with_avx(two)):
        sys.exit(f"{two} has instructions that not every processor has:\n" + "\n".join(sorted(baseline)))
    both = sorted(
        name for name in plain(shared_names(four) & shared_names(two)) if "contactd" in name and "LaneFft" not in name
    )
    if both:
        sys.exit("Both instruction sets have functions of the same name, of which one is kept:\n" + "\n".join(both))


if __name__ == "__main__":
    main(sys.argv[1:])

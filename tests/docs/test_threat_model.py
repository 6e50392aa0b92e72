"""Tests that the threat model of docs/security.md has a row for each method, and for each kind of file that is
read."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
#: Maps readers of files with given names, below the root, to a word in the row of these files.
READERS = {
    "client/python/contactctl/array_files.py": "`.npy`",
    "client/python/contactctl/cases/files.py": "`.out`",
    "client/python/contactctl/commands/fit.py": "`.csv`",
    "client/python/contactctl/commands/keys.py": "keys",
    "client/python/contactctl/commands/session.py": "`.csv`",
    "client/python/contactctl/files.py": "`.yaml`",
    "client/python/contactctl/study/journal.py": "`.rows`",
    "client/python/contactctl/study/shares.py": "`.rows`",
    "client/python/contactctl/table_files.py": "IC file (`.h5`) of a stranger",
    "client/python/contactctl/wearing/shares.py": "states and steps of wear",
    "client/python/contactd/files/case_text.py": "`.inp`",
    "client/python/contactd/files/contact_text.py": "`.txt`",
    "client/python/contactd/files/profile_text.py": "profiles",
    "client/python/contactd/files/ic_files.py": "IC file (`.h5`) of a stranger",
    "client/python/contactd/files/saved.py": "problem or solution (`.h5`)",
    "client/python/contactd/files/table_files.py": "`.npz`",
    "client/python/contactctl/conformity/benchmark_files.py": "values of a benchmark",
    "client/python/contactctl/conformity/run_files.py": "forces along a run",
    "client/python/contactd/track/run.py": "runs of a wheel over a track",
    "client/python/contactd/roughness/reading.py": "records of roughness",
    "client/python/contactd/wear/states.py": "states and steps of wear",
    "client/python/contactd/transport/curve.py": "keys",
    "cases/given/named_files.cpp": "`.txt`",
    "client/cntc/src/interface/input_file.cpp": "`.inp`",
    "client/fmu/instance/serialized.cpp": "saved states of FMUs",
    "client/fmu/models/slices.cpp": "lists of slices",
    "core/src/store/ic_file.cpp": "IC file in the store",
    "core/profile_files/read_profile.cpp": "profiles",
    "proto/src/wire/key_file.cpp": "keys",
    "server/contactd_ic/main.cpp": "problems",
    "server/src/config/config.cpp": "configuration",
}
#: Readers of the store's own files, and of /proc and /sys.
OF_THE_SYSTEM = {
    "core/src/platform/posix.cpp",
    "core/src/platform/windows.cpp",
    "core/src/store/hdf5/writer.cpp",
    "engine/ics/build/builder.cpp",
    "server/contactd_ic/memory.cpp",
    "server/src/operation/metrics/process_metrics.cpp",
}
_READS = re.compile(r"\bread_whole\(|\bifstream\b|\bO_RDONLY\b|\bUse::reading\b|\bdeserialized\(const Kind")


def first_cells():
    page = (ROOT / "docs/security.md").read_text()
    rows = page.partition("## Threat model")[2].partition("\n## ")[0]
    return "".join(line.split("|")[1] for line in rows.splitlines() if line.startswith("|"))


def test_each_method_has_a_row():
    named = set(re.findall(r"`([a-z_]+\.[a-z_*]+)`", first_cells()))
    methods = {path.name.removesuffix(".params.json") for path in (ROOT / "proto/schema").glob("*.params.json")}
    families = {name.removesuffix("*") for name in named if name.endswith("*")}
    unnamed = {method for method in methods if method not in named and not any(method.startswith(f) for f in families)}
    assert not unnamed, f"without a row in the threat model: {sorted(unnamed)}"
    stale = {name for name in named if not name.endswith("*")} - methods
    assert not stale, f"rows of no method: {sorted(stale)}"


def test_each_kind_of_file_has_a_row():
    sources = [path for part in ("core", "cases", "engine", "server", "proto", "client") for path in (ROOT / part).rglob("*.[ch]pp")]
    sources += [path for part in ("contactd", "contactctl") for path in (ROOT / "client/python" / part).rglob("*.py")]
    reading = {path.relative_to(ROOT).as_posix() for path in sources if _READS.search(path.read_text())}
    reading -= {"client/python/contactd/files/whole.py", "client/fmu/instance/serialized.hpp"}  # for the others
    assert reading == READERS.keys() | OF_THE_SYSTEM
    cells = first_cells()
    unnamed = {reader: word for reader, word in READERS.items() if word not in cells}
    assert not unnamed, f"without a row in the threat model: {unnamed}"

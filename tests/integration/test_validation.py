"""Tests `./dev validate` on files of contactd's own results, with one number changed by hand."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from contactd.contact_files.out_file import lines_of, out_text
from paper.rows import read_csv
from support.contact_runs import computed_file
from support.daemons import BIN
from validation.__main__ import validate
from validation.given import FilesMissing

BASIC = """\
3 MODULE
203100 P-B-T-N-F-S
022020 L-D-C-M-Z-E
0000301 H-G-I-A-O-W-R
999 20 25 1 1e-6
50000. 0.0005 0. 0.0001
0.3 0.3
0. 0.5 20000.
0.28 0.28 82000. 82000.
-3
15 15 6. 4. 1.1
3 MODULE
203100
100000
0100301
50000. 0.002 0. 0.0001
3 MODULE
202100
102100
0100301
50000. 0.002 0. 0.0001
0. 0.5 20000.
0.28 0.28 82000. 82000.
100. 0.01 0. 0.
3 MODULE
002100
100100
0100301
50000. 0.002 0. 0.0001
0 MODULE
"""
RAILS = """\
1 MODULE
1203100 C-P-B-T-N-F-S
0022033 V-L-D-C-M-Z-E
0000301 H-G-I-A-O-W-R
999 20 25 1 1e-6
0.3 0.3
0.28 0.28 82000. 82000.
0.5 0.5 1. 90d 8. 4.
-1. 750. 0. 0.
'rail.txt' 0 1. 0. -1
0. 0. 0. 0. 0. 0.
1360. -70. 460.
'wheel.txt' 0 1. 0. -1
0. 1. 10000.
0. 0.001 0.
2000. 0. 0. 0. 0.
-4.348
0 MODULE
"""
TIMERS = "|Total                |        1 |       59.0 | 100.0 |       60.0 | 100.0 |\n"


@pytest.fixture
def given(tmp_path, shared):
    """Creates two files; the longitudinal force of the second case of the first one is changed by 1 %."""
    folder = tmp_path / "given" / "examples"
    folder.mkdir(parents=True)
    y = np.linspace(-40, 40, 161)
    for name, points in (("rail", (y, y**2 / 600)), ("wheel", (y[::-1], -0.025 * y[::-1]))):
        (folder / f"{name}.txt").write_text("".join(f"{a:.4f} {b:.6f}\n" for a, b in zip(*points)))
    for name, text in (("own", BASIC), ("mbench_own", RAILS)):
        (folder / f"{name}.inp").write_text(text)
        (folder / f"{name}.ref_out").write_text(printed(folder / f"{name}.inp", shared) + TIMERS)
    path = folder / "own.ref_out"
    before, after = path.read_text().split(" Case     2")
    force = re.search(r"(FN +FX .*\n +\S+ +)(\S+)", after)
    path.write_text(f"{before} Case     2{after.replace(force[0], f'{force[1]}{1.01 * float(force[2]):.6g}', 1)}")
    files = [
        {"file": f"examples/{name}.inp", "reference": f"examples/{name}.ref_out"} for name in ("own", "mbench_own")
    ]
    (folder.parent / "cases_given.json").write_text(json.dumps({"files": files}))
    return folder.parent


def printed(path, client):
    return out_text(lines_of(solved) for solved in computed_file(client, path, "bilinear"))


def test_given_cases_are_put_beside_what_is_printed(given, tmp_path):
    folder = tmp_path / "docs" / "validation"
    validate(given, None, folder, "development", lambda line: None)
    rows = read_csv(folder / "cases.csv")
    whole = [row for row in rows if row["patch"] == ""]
    assert [row["status"] for row in whole] == ["agrees", "differs", "refused", "follows", "agrees"]
    assert whole[1]["Fx_over"] == pytest.approx(0.01 * abs(whole[1]["Fx"]) / (5e-4 * 15000), rel=0.05)
    assert whole[1]["Fn_over"] < 1
    assert "viscoelastic" in whole[2]["note"]
    (patch,) = [row for row in rows if row["patch"] == 1]
    assert (patch["family"], patch["module"]) == ("mbench", 1)
    assert patch["over"] < 1
    assert patch["over_exact"] >= patch["over"]
    times = read_csv(folder / "times.csv")
    assert [(row["cases"], row["computed"], row["printed_seconds"]) for row in times] == [(4, 2, 60), (1, 1, 60)]
    page = (folder.parent / "validation.md").read_text()
    assert "Of 3 cases that are computed 2 agree and 1 differ." in page
    assert "{{" not in page
    assert {path.name for path in folder.glob("*.png")} == {"examples.png", "mbench.png"}


def test_one_family_is_computed_and_the_others_stay(given, tmp_path):
    folder = tmp_path / "docs" / "validation"
    validate(given, None, folder, "development", lambda line: None)
    before = read_csv(folder / "cases.csv")
    validate(given, "mbench", folder, "production", lambda line: None)
    assert [row["file"] for row in read_csv(folder / "cases.csv")] == [row["file"] for row in before]
    assert [row["preset"] for row in read_csv(folder / "times.csv")] == ["development", "production"]
    with pytest.raises(ValueError, match="'other' is not a family; use examples, mbench"):
        validate(given, "other", folder, "production", lambda line: None)


def test_printed_cases_that_are_others_are_refused(given, tmp_path):
    path = given / "examples" / "own.ref_out"
    path.write_text(path.read_text().split(" Case     4")[0])
    with pytest.raises(FilesMissing, match=r"own\.ref_out prints 3 cases, and .*own\.inp has 4"):
        validate(given, None, tmp_path / "docs", "development", lambda line: None)
    assert not (tmp_path / "docs").exists()


def test_without_the_files_the_command_says_so_and_writes_nothing(tmp_path):
    words = ["--bin", BIN, "--cases", tmp_path / "none", "--output", tmp_path / "docs" / "validation"]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    ended = subprocess.run(
        [sys.executable, "-m", "validation", *words], capture_output=True, text=True, env=environment
    )
    assert ended.returncode == 1
    assert "none/cases_given.json is missing" in ended.stderr
    assert list(Path(tmp_path).iterdir()) == []

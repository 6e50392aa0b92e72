"""profiles list, show and write."""

from __future__ import annotations

import numpy as np
import pytest

from contactd.standard_profiles import OMITTED, STANDARDS


def test_a_list_has_sources_and_what_is_left_out(ctl):
    shown = ctl("profiles", "list")
    assert shown.code == 0, shown.err
    for said in (*STANDARDS, *OMITTED, "EN 13674-1:2017", "disagree by 0.74 mm"):
        assert said in shown.out
    told = ctl("profiles", "list", "--json").json
    assert [one["name"] for one in told["profiles"]] == list(STANDARDS)
    assert told["profiles"][0]["year"] == 2020 and "year" not in told["profiles"][1]
    assert told["omitted"] == dict(OMITTED)


@pytest.mark.parametrize(("name", "other"), [("54e1", "under S1002"), ("S1002", "on UIC60")])
def test_a_profile_is_shown_with_its_conicity(ctl, name, other):
    pytest.importorskip("matplotlib")
    shown = ctl("profiles", "show", name, "-o", "one.png")
    assert shown.code == 0, shown.err
    for said in (name.upper(), "second source", other, "rails at 1/40"):
        assert said in shown.out
    assert (ctl.folder / "one.png").read_bytes()[1:4] == b"PNG"
    told = ctl("profiles", "show", name, "--json").json
    assert [one["amplitude"] for one in told["conicities"]["1/40"]] == list(range(1, 8))
    assert np.shape(told["points"])[1] == 2


@pytest.mark.parametrize("name", STANDARDS)
def test_files_are_the_profile_that_they_are_named_for(ctl, name):
    written = ctl("profiles", "write", name, "made", "--json").json
    files = [f"made/{name}{ending}" for ending in ((".prw", ".whl") if name == "S1002" else (".prr", ".ban"))]
    assert written["files"] == files
    points = ctl("profiles", "show", name, "--json").json["points"]
    for file in files:
        assert ctl("profile", "show", file, "--json").json["points"] == points
    assert ctl("profiles", "write", name, "made").code == 0  # contactd has written them
    (ctl.folder / files[1]).write_text("mine\n")
    refused = ctl("profiles", "write", name, "made")
    assert refused.code == 2 and "contactd did not write it" in refused.err


def test_an_inclined_rail_is_written_inclined(ctl):
    assert ctl("profiles", "write", "60E2", "--inclination", 0.025).code == 0
    assert "inclined by 0.025" in (ctl.folder / "60E2.prr").read_text()
    points = np.array(ctl("profile", "show", "60E2.prr", "--json").json["points"])
    assert points[:, 1].min() == pytest.approx(0, abs=1e-4)
    assert np.subtract(*points[[-1, 0], 1]) / np.subtract(*points[[-1, 0], 0]) == pytest.approx(-0.025, rel=1e-9)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("show", "49E1"), 2, "49E1 is left out: its two sources disagree"),
        (("write", "60E3"), 2, "Did you mean"),
        (("show", "60E1", "-o", "one.doc"), 2, "must end in"),
        (("write", "S1002", "--inclination", 0.025), 4, "S1002"),
    ],
)
def test_what_there_is_not_is_refused(ctl, words, code, said):
    ended = ctl("profiles", *words)
    assert ended.code == code and said in ended.err

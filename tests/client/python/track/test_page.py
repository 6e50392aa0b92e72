"""Tests the examples of docs/track.md."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

PAGE = Path(__file__).parents[4] / "docs" / "track.md"


@pytest.mark.timeout(300)
def test_examples_show_what_the_page_states():
    names: dict = {}
    for example in re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, str(PAGE), "exec"), names)
    for peaks in names["peaks"].values():  # a hump, a dip, then growth
        turns = np.sign(np.diff(peaks))
        assert turns[0] > 0 > turns.min()
        assert turns[-1] > 0
    assert min(names["peaks"]["fresh"]) > names["wheel"].load
    _, unfiltered = names["third_octaves"](names["unfiltered"].force, 20e3, 100, 4000, 0.04)
    ratio = 20 * np.log10(unfiltered / names["levels"])
    assert np.abs(ratio[:4]).max() < 1  # long waves are not filtered
    assert ratio[-3] > 8

"""Pictures of worn profiles."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure

from contactd import InvalidArgument
from contactd.pictures.wear import (
    draw_competition,
    draw_depths,
    draw_groups,
    draw_measures,
    draw_shakedown,
    draw_worn,
    shakedown_limit,
)
from contactd.wear import StepFatigue, WornStep

Y = np.linspace(-20, 20, 81)
EDGES = np.linspace(0, 40, 41)


def step(number: int, depth: float, fatigue: StepFatigue | None = None) -> WornStep:
    points = np.stack([Y, depth * np.exp(-((Y / 5) ** 2))], axis=1)
    return WornStep(number, 100.0 * number, points, EDGES, np.full(40, depth), groups={"curve": depth, "straight": 2 * depth}, fatigue=fatigue)


TIRED = StepFatigue({"ours": np.linspace(-1e-3, 1e-3, 40)}, np.full(40, 150.0), np.full(40, 1.1), np.array([[0.1, 3, 3.5, 0.5], [0.3, 4, 3.0, 0.5]]))
STEPS = [step(0, 0.0), step(1, 0.1, TIRED), step(2, 0.2, TIRED)]


def test_johnsons_limits_of_a_line_contact():
    np.testing.assert_allclose(shakedown_limit([0, 0.1, 0.2, 0.3, 0.4, 0.5]), [4.00, 3.56, 3.20, 2.90, 2.50, 2.00], atol=0.01)


def test_pictures_show_what_steps_have():
    figure = Figure()
    worn, depths, groups, shakedown, cracks, measures = figure.subplots(2, 3).flat
    draw_worn(worn, STEPS, 10)
    assert "200 km, wear 10 times as large" in worn.get_legend().get_texts()[1].get_text()
    draw_depths(depths, STEPS)
    np.testing.assert_allclose(depths.lines[-1].get_ydata().max(), 0.2, rtol=1e-4)
    draw_groups(groups, STEPS)
    assert [text.get_text() for text in groups.get_legend().get_texts()] == ["curve", "straight"]
    draw_shakedown(shakedown, STEPS)
    assert "load beyond it" in [text.get_text() for text in shakedown.get_legend().get_texts()]
    draw_competition(cracks, STEPS, "ours")
    np.testing.assert_allclose(cracks.lines[0].get_ydata().max(), 2e-3, rtol=1e-6)
    draw_measures(measures, [0, 100], {"Sd": [32.5, 32.4]}, label="mm")
    assert measures.get_ylabel() == "mm"


def test_groups_are_called_what_files_call_them():
    figure = Figure()
    groups, cracks = figure.subplots(1, 2)
    named = [replace(one, groups={"_of $x_{$": 1.0, "R 300 m " * 9: 2.0}) for one in STEPS]
    draw_groups(groups, named)
    texts = [text.get_text() for text in groups.get_legend().get_texts()]
    assert texts[0].startswith("R 300 m R") and texts[0].endswith("...") and len(texts[0]) <= 40
    assert texts[1] == r" _of \$x_{\$"
    tired = replace(TIRED, damages={"$\\frac{$": np.ones(40)})
    draw_competition(cracks, [STEPS[0], replace(STEPS[1], fatigue=tired)], "$\\frac{$")
    figure.savefig(io.BytesIO())  # an invalid formula would cause an error here


def test_of_many_groups_those_are_told_apart_that_take_most():
    axes = Figure().subplots()
    draw_groups(axes, [replace(one, groups={f"curve {i:02}": float(i) for i in range(30)}) for one in STEPS])
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [*(f"curve {i}" for i in range(25, 30)), "25 others"]
    assert len({tuple(part.get_facecolor()[0]) for part in axes.collections}) == 6
    top = axes.collections[-1].get_paths()[0].vertices[:, 1].max()
    assert top == pytest.approx(3 * sum(range(30)))


def test_what_is_not_there_is_not_drawn():
    axes = Figure().subplots()
    with pytest.raises(InvalidArgument, match="so there is no wear"):
        draw_worn(axes, STEPS[:1])
    with pytest.raises(InvalidArgument, match="no damage by theirs"):
        draw_competition(axes, STEPS, "theirs")
    with pytest.raises(InvalidArgument, match="no loads"):
        draw_shakedown(axes, [step(0, 0.0), step(1, 0.1)])

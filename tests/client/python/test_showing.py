"""Tests representations: help(), a line on a terminal, a table in a notebook."""

import dataclasses
import inspect
import pydoc
import re
import sys
from html.parser import HTMLParser

import numpy as np
import pytest

import contactd
from contactd import (
    AnalyticIcs,
    Client,
    FemIcs,
    Grid,
    IcEvidence,
    IcTable,
    LargestStress,
    Material,
    SubsurfaceStress,
    TableIcs,
)
from contactd.values.answers import read
from contactd.values.solution import ContactSolution
from contactd.values.step_solution import StepSolution
from contactd.values.tables import IcSpec
from support import answers

DATA = sorted(
    {
        kind
        for name, module in sys.modules.items()
        if name.startswith("contactd.values.")
        for kind in vars(module).values()
        if isinstance(kind, type) and dataclasses.is_dataclass(kind) and kind.__module__.startswith("contactd.")
    },
    key=lambda kind: kind.__name__,
)


class Cells(HTMLParser):
    """Returns the texts of a table; fails for tags that are not closed in order."""

    def __init__(self, text):
        super().__init__()
        self.texts, self._open = [], []
        self.feed(text)
        assert not self._open

    def handle_starttag(self, tag, attributes):
        self._open.append(tag)

    def handle_endtag(self, tag):
        assert self._open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def solution(kind=ContactSolution, **changes):
    result, *_ = answers.solution(2, 3)
    for name in ["element_division", "pressure", "traction_x", "traction_y"]:
        result[name] = np.zeros((2, 3))
    return read(kind, {**result, "step": 3, **changes})


def table(warnings=()):
    spec = IcSpec(Material(82000, 0.28), Grid(3, 2, 0.8, 0.8), FemIcs(accuracy=1e-3, body="block", L_over_h=20))
    return IcTable("key", "built", spec, np.full((3, 3, 2, 3), 0.25), IcEvidence("fem", warnings=warnings))


# --- help() ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", [k for k in DATA if dataclasses.fields(k)], ids=lambda kind: kind.__name__)
def test_help_describes_every_field(kind):
    text = pydoc.plain(pydoc.render_doc(kind))
    attributes = text.partition("Attributes:")[2]
    for field in dataclasses.fields(kind):
        assert re.search(rf"\n[ |]+{field.name}: \S", attributes), field.name


@pytest.mark.parametrize(
    ("kind", "field", "words"),
    [
        (contactd.Material, "G", "N/mm^2"),
        (contactd.Grid, "dx", "(mm)"),
        (contactd.ContactProblem, "approach", "> 0 in compression"),
        (contactd.ContactProblem, "Fn", "(N)"),
        (contactd.Rolling, "phi", "rad/mm"),
        (contactd.Friction, "force", "on the upper body (N)"),
        (ContactSolution, "traction_x", "on the upper body, shape [ny, nx] (N/mm^2)"),
        (ContactSolution, "frictional_power", "N mm/s"),
        (IcTable, "array", "[3, 3, ny, nx] (mm^3/N)"),
    ],
)
def test_help_tells_units_shapes_and_signs(kind, field, words):
    line = re.search(rf"\n {{4}}{field}: (.*?)(?=\n {{4}}\w|\n\n|$)", inspect.getdoc(kind), re.DOTALL)
    assert words in re.sub(r"\s+", " ", line.group(1))


# --- lines -----------------------------------------------------------------------------------------------------------


def test_a_solution_shows_its_forces_and_no_arrays():
    text = repr(solution())
    assert text.startswith("<ContactSolution on 3 x 2 elements: Fn 9.2, Fx -3.2, Fy 0, Mz 0.5, ")
    assert "array" not in text
    assert "\n" not in text
    assert "converged yes" in text


def test_a_solution_that_did_not_converge_or_warns_says_so():
    text = repr(solution(converged=False, warnings=["Beware.", "Take care."]))
    assert "converged NO, 2 warnings>" in text


def test_a_step_shows_its_number():
    assert repr(solution(StepSolution)).startswith("<StepSolution 3: Fn 9.2")


def test_a_table_shows_what_it_is_of():
    assert repr(table(("Beware.",))) == (
        "<IcTable of 3 x 2 offsets: G 82000, nu 0.28, dx 0.8, dy 0.8, "
        "source finite elements, accuracy 0.001 body block L_over_h 20, origin built, zz at the origin 0.25, 1 warning>"
    )
    assert "source closed form" in repr(dataclasses.replace(table(), spec=IcSpec(Material(1, 0), Grid(3, 2, 1, 1), AnalyticIcs())))
    assert repr(TableIcs(np.ones((3, 3, 2, 3)), 1, 2)) == "<TableIcs of 3 x 2 offsets: dx 1, dy 2, zz at the origin 1>"


def test_stresses_show_where_they_are_largest():
    arrays = [np.zeros(4)] * 7
    stress = SubsurfaceStress(*arrays, LargestStress(1.5, 0, 0, -0.4, 0.4))
    assert repr(stress) == "<SubsurfaceStress at 4 points: largest von Mises 1.5, at x 0, y 0, z -0.4>"


def test_a_client_shows_where_it_asks():
    client = Client("tcp://127.0.0.1:1", timeout=5)
    assert repr(client) == "<Client of tcp://127.0.0.1:1: timeout 5 s, builds 3600 s, encryption none, state open>"
    client.close()
    assert "state closed" in repr(client)


# --- tables ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("shown", [solution(), solution(StepSolution), table()], ids=lambda shown: type(shown).__name__)
def test_a_notebook_shows_a_small_table(shown):
    texts = Cells(shown._repr_html_()).texts
    assert texts[0].startswith(type(shown).__name__)
    assert 10 < len(texts) < 40


def test_a_notebook_shows_warnings_whole_and_nothing_as_markup():
    hostile = '<script>alert("x")</script> & more'
    text = solution(warnings=[hostile])._repr_html_()
    assert "<script>" not in text
    assert hostile in Cells(text).texts
    with Client('ipc:///<b>"x"') as client:
        assert "<b>" not in client._repr_html_()

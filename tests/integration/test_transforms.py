"""Tests that daemons with the transforms of ducc0 and of FFTW have equal answers within tolerances, and name their
library."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from contactd import Client, ContactProblem, Friction, Grid, Layer, LayeredBody, Material, Rolling, SolverSettings
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.daemons import Daemons
from support.problems import CATTANEO, QUICK

BUILD = Path(__file__).parents[2] / "build"
#: Differences of solves to a tolerance of 1e-6, over the largest pressure and the bound of friction.
TOLERANCE = 2e-5

pytestmark = [
    pytest.mark.long,  # ./dev test --long builds both
    pytest.mark.timeout(300),
]


@pytest.fixture(scope="module")
def both() -> Iterator[tuple[Client, Client]]:
    started = Daemons()
    try:
        clients = []
        for name in ("development", "fftw"):
            program = BUILD / name / "bin" / "contactd"
            assert program.exists(), f"{program} is missing. Build it by ./dev build {name}."
            clients.append(started.start(name, program=program).client())
        with clients[0], clients[1]:
            yield clients[0], clients[1]
    finally:
        started.finish()


ROLLING = Friction(mu=0.3, rolling=Rolling(xi=0.002, eta=0.001, phi=1e-3))
CONTACTS = {
    "shift": CATTANEO,
    "rolling": CATTANEO.replace(friction=ROLLING),
    "transient rolling": CATTANEO.replace(friction=Friction(mu=0.3, rolling=Rolling(kind="transient", xi=0.01, steps=4))),
    "dissimilar bodies": CATTANEO.replace(lower=Material(G=900, nu=0.1), friction=ROLLING),
    "a force": CATTANEO.replace(approach=None, Fn=0.2),
    "an odd number of elements": CATTANEO.replace(grid=Grid.centred(37, 41, 2.4, 2.4)),
    "a layer": CATTANEO.replace(upper=LayeredBody((Layer(0.3, G=100, nu=0.3),), CATTANEO.upper)),
    "finite elements": CATTANEO.replace(ics=QUICK),
}


@pytest.mark.parametrize("problem", CONTACTS.values(), ids=CONTACTS)
def test_contacts_have_the_same_answer(both, problem: ContactProblem):
    exact = SolverSettings(1e-8)
    problem = problem.replace(normal=exact, tangential=exact, outer=exact)
    one, other = (client.solve(problem) for client in both)
    assert one.converged
    assert other.converged
    assert one.elements.contact == other.elements.contact
    for name in ("pressure", "traction_x", "traction_y"):
        np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=0, atol=TOLERANCE * one.pmax)


@pytest.mark.parametrize("conformal", [None, "half_space"])
@pytest.mark.parametrize("y", [0.0, 6.0])
def test_a_wheel_on_its_rail_has_the_same_answer(both, y, conformal):
    setup = WheelRailSetup(side="right", conformal=conformal, dx=0.5, dy=0.5)
    state = WheelRailState(position=WheelsetPosition(y=y, yaw=0.01), velocity=WheelsetVelocity(x=4000.0, pitch=-8.68), Fz=8e4)
    one, other = (client.wheel_rail(setup, state) for client in both)
    assert len(one.patches) == len(other.patches)
    assert other.z == pytest.approx(one.z, abs=1e-6)
    for name in ("Fx", "Fy", "Fz"):
        assert getattr(other.forces.track, name) == pytest.approx(getattr(one.forces.track, name), abs=TOLERANCE * 8e4)


def test_each_names_its_transforms(both):
    of_ducc0, of_fftw = (client.info().libraries for client in both)
    assert "ducc0" in of_ducc0
    assert "fftw" not in of_ducc0
    assert "fftw" in of_fftw
    assert "ducc0" not in of_fftw


def test_the_evidence_of_a_table_names_the_transforms_of_its_build(both):
    for client, name in zip(both, ("ducc0", "fftw"), strict=True):
        table = client.get_ic(CATTANEO.upper, CATTANEO.grid, QUICK)
        assert f", {name} " in table.evidence.version

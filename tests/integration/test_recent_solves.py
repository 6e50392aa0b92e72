"""Tests solves.recent and solves.pressures, which report a user's last solves."""

import pytest

from contactd import NotFound, TimeoutExpired
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.problems import CATTANEO, ENDLESS

COARSE = WheelRailSetup(side="right", dx=0.8, dy=0.8)
CENTRED = WheelRailState(position=WheelsetPosition(y=0), velocity=WheelsetVelocity(x=2000, pitch=-4.35), Fz=1e4)


def test_every_way_to_solve_is_told(client):
    client.solve(CATTANEO)
    client.solve_many([CATTANEO, CATTANEO])
    with client.session(CATTANEO) as session, client.session(CATTANEO) as other:
        session.step()
        client.step_many([(session, {}), (other, {})])
    client.wheel_rail(COARSE, CENTRED)
    with client.wheel_rail_session(COARSE) as wheel:
        wheel.step(CENTRED)
    solves = client.recent_solves()
    assert [solve.number for solve in solves] == list(range(8, 0, -1))
    assert [solve.method for solve in reversed(solves)] == [
        "contact.solve", "contact.solve_many", "contact.solve_many", "session.step", "session.step_many",
        "session.step_many", "wheelrail.solve", "session.step",
    ]  # fmt: skip
    assert all(solve.converged and solve.has_pressures and solve.seconds > 0 for solve in solves)


def test_figures_are_those_of_the_answer(client):
    solution = client.solve(CATTANEO)
    (recent,) = client.recent_solves()
    assert recent.forces == (solution.Fx, solution.Fy, solution.Fn)
    assert recent.pmax == solution.pmax
    assert recent.grid == CATTANEO.grid
    assert recent.iterations == solution.evidence.normal.iterations + solution.evidence.tangential.iterations


def test_a_wheel_has_the_pressures_of_its_patches(client):
    solution = client.wheel_rail(COARSE, CENTRED)
    (recent,) = client.recent_solves()
    assert recent.grid is None
    assert recent.forces[2] == pytest.approx(solution.forces.track.Fz)
    patches = client.recent_pressures(recent.number)
    assert [patch.grid for patch in patches] == [patch.place.grid for patch in solution.patches]
    assert patches[0].pressure == pytest.approx(solution.patches[0].solution.pressure, rel=1e-6)


def test_what_does_not_end_is_not_among_them(client):
    with pytest.raises(TimeoutExpired):
        client.solve(ENDLESS, timeout=0.2)
    assert client.recent_solves() == ()


def test_the_configuration_bounds_them(daemons):
    daemon = daemons.start(recent_solves={"count": 2, "max_bytes": 10_000})
    with daemon.client() as client:
        for _ in range(3):
            client.solve(CATTANEO)
        latest, before = client.recent_solves()
        assert (latest.number, before.number) == (3, 2)
        assert (latest.has_pressures, before.has_pressures) == (True, False)
        with pytest.raises(NotFound):
            client.recent_pressures(before.number)


def test_a_count_of_none_keeps_none(daemons):
    with daemons.start(recent_solves={"count": 0}).client() as client:
        client.solve(CATTANEO)
        assert client.recent_solves() == ()


def test_the_configuration_is_told_without_what_is_secret(client, daemon):
    config = client.config()
    assert config["recent_solves"] == {"count": 50, "max_bytes": 4194304}
    assert config["security"]["encrypted"] is False
    assert "curve" not in config["security"]
    assert str(daemon.folder) not in repr(config)
    assert not {"endpoint", "http"} & set(config)

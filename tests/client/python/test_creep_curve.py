"""Tests curves of creep forces: many contacts with different creepages."""

from __future__ import annotations

import asyncio
import warnings

import matplotlib
import numpy as np
import pytest

import contactd
from contactd import AsyncClient, ContactWarning, Friction, InvalidArgument, Paraboloid, Rolling, steel

matplotlib.use("Agg")

WHEEL = Paraboloid(460, 300)
FRICTION = Friction(0.3)


def test_points_are_those_of_single_solves(client):
    rolling = Rolling(velocity=2e4, chi=np.pi)
    curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=Friction(0.3, rolling=rolling), xi=[5e-4, 2e-3], eta=1e-3, phi=1e-4)
    for index, xi in enumerate([5e-4, 2e-3]):
        motion = Rolling(velocity=2e4, chi=np.pi, xi=xi, eta=1e-3, phi=1e-4)
        one = client.solve(WHEEL, steel, Fn=80e3, friction=Friction(0.3, rolling=motion))
        assert (curve.Fx[index], curve.Fy[index], curve.Mz[index]) == (one.Fx, one.Fy, one.Mz)
        assert (curve.Fn[index], curve.pmax[index], curve.converged[index]) == (one.Fn, one.pmax, True)
    assert curve.grid == one.grid


def test_forces_oppose_creepages_and_end_at_the_friction_bound(client):
    xi = np.array([-0.02, -1e-3, 0, 1e-3, 0.02])
    curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=xi)
    assert curve.Fx[[0, -1]] == pytest.approx([24e3, -24e3], rel=1e-3)
    assert curve.Fx == pytest.approx(-curve.Fx[::-1], abs=1e-3)
    assert curve.Fy == pytest.approx(np.zeros(5), abs=1e-3)


def test_arrays_are_broadcast(client):
    curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[[1e-3], [-1e-3]], eta=[0, 1e-3, 2e-3], phi=0)
    for values in (curve.xi, curve.eta, curve.phi, curve.Fn, curve.Fx, curve.Fy, curve.Mz, curve.pmax, curve.converged):
        assert values.shape == (2, 3)
        assert not values.flags.writeable
    assert (curve.xi[1] == -1e-3).all()
    assert curve.Fx[0] == pytest.approx(-curve.Fx[1], rel=1e-6)
    assert client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=1e-3).Fx.shape == ()


def test_a_problem_is_taken_with_its_grid_and_model(client):
    problem = contactd.ContactProblem(
        grid=contactd.Grid.centred(20, 20, 16, 14), gap=WHEEL, upper=steel, Fn=80e3, friction=FRICTION, model="fastsim"
    )
    curve = client.creep_curve(problem, xi=[1e-3, 0.05])
    assert curve.grid == problem.grid
    assert curve.Fx[1] == pytest.approx(-24e3, rel=0.01)


def test_more_points_than_a_message_holds(client):
    problem = contactd.ContactProblem(
        grid=contactd.Grid.centred(8, 8, 16, 14), gap=WHEEL, upper=steel, Fn=80e3, friction=FRICTION, model="polach"
    )
    curve = client.creep_curve(problem, xi=np.linspace(0, 0.01, 1203))
    assert curve.converged.all()
    assert (np.diff(curve.Fx) < 0).all()


def test_points_that_fail_are_nan_and_named_and_the_others_are_solved(client):
    with pytest.warns(ContactWarning) as told:
        curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[1e-3, np.nan, 1e13], eta=[[0], [1e-3]])
    (warning,) = told
    assert "4 of 6 points failed and are NaN: point [0, 1]: xi[0, 1] is nan" in str(warning.message)
    assert warning.filename == __file__
    assert np.isnan(curve.Fx).tolist() == [[False, True, True]] * 2
    assert np.isnan(curve.pmax).sum() == 4
    assert set(curve.errors) == {(0, 1), (0, 2), (1, 1), (1, 2)}
    assert all(isinstance(error, InvalidArgument) for error in curve.errors.values())
    assert curve.converged.tolist() == [[True, False, False]] * 2


def test_masked_points_are_not_solved(client):
    with pytest.warns(ContactWarning, match="1 of 2 points failed"):
        curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=np.ma.array([1e-3, 2e-3], mask=[0, 1]))
    assert np.isnan(curve.Fx).tolist() == [False, True]


def test_points_that_do_not_converge_keep_their_values_and_are_counted(client):
    with pytest.warns(ContactWarning, match="2 of 2 points did not converge"):
        curve = client.creep_curve(
            WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[1e-3, 2e-3],
            tangential=contactd.SolverSettings(max_iterations=1, tolerance=1e-12),
        )  # fmt: skip
    assert not curve.converged.any()
    assert np.isfinite(curve.Fx).all()
    assert not curve.errors


def test_what_a_point_warns_of_names_the_point(client):
    with pytest.warns(ContactWarning, match=r"point \[1, 0\]: .*creepage"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[[1e-3], [0.8]])


def test_where_all_points_fail_the_exception_comes(client):
    with pytest.raises(InvalidArgument, match=r"xi\[0\] is nan"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[np.nan, np.inf])
    with pytest.raises(InvalidArgument, match=r"friction\.mu is -0\.3"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=Friction(-0.3), xi=[0, 1e-3])


@pytest.mark.parametrize(
    ("friction", "sentence"),
    [
        (None, "needs a coefficient of friction"),
        (Friction(0.3, rigid_shift=(1e-3, 0)), "friction.rigid_shift is that of a shift"),
        (Friction(0.3, rolling=Rolling(force=(-100, 0))), "friction.rolling.force is given"),
    ],
)
def test_friction_that_is_not_that_of_a_curve_is_refused(client, friction, sentence):
    with pytest.raises(TypeError, match=sentence):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=friction, xi=[0, 1e-3])


def test_shapes_that_do_not_go_together_are_refused(client):
    with pytest.raises(InvalidArgument, match=r"do not broadcast together; their shapes are xi \[2\], eta \[3\]"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[0, 1], eta=[0, 1, 2])
    with pytest.raises(InvalidArgument, match="have no points"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[])
    with pytest.raises(InvalidArgument, match="xi is 'much'; it must be a number"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi="much")


def test_a_curve_draws_itself_over_what_varies(client):
    curve = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=1e-4, eta=np.linspace(0, 0.01, 5))
    axes = curve.plot()
    assert axes.get_xlabel() == "lateral creepage"
    assert [line.get_label() for line in axes.get_lines()] == ["$-F_x/F_n$", "$-F_y/F_n$"]
    assert axes.get_lines()[1].get_ydata() == pytest.approx(-curve.Fy / 80e3)
    matplotlib.pyplot.close("all")
    with pytest.raises(ValueError, match="one dimension"):
        client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[[0, 1e-3]]).plot()
    assert repr(curve).startswith("<CreepCurve of 5 points on 40 x 40 elements: xi 0.0001")


def test_a_coroutine_does_the_same(shared_daemon, client):
    async def found():
        async with AsyncClient(shared_daemon.endpoint) as asking:
            return await asking.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[0, 1e-3])

    with warnings.catch_warnings():
        warnings.simplefilter("error", ContactWarning)
        expected = client.creep_curve(WHEEL, steel, Fn=80e3, friction=FRICTION, xi=[0, 1e-3])
    assert np.array_equal(asyncio.run(found()).Fx, expected.Fx)

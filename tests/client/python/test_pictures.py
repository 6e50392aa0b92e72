"""Tests pictures of answers: contents, units, and errors if there is nothing to draw."""

import subprocess
import sys
import warnings

import matplotlib
import numpy as np
import pytest

import contactd
from contactd import (
    AnalyticIcs,
    ContactProblem,
    Friction,
    Grid,
    Material,
    MissingExtra,
    Paraboloid,
    Progress,
    Rolling,
    SemiAxes,
    StressBlock,
)
from contactd.pictures import ConvergenceHistory, plot_creep_curves
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STEEL = Material(82000, 0.28)
PROBLEM = ContactProblem(
    grid=Grid.centred(15, 12, 16, 12), upper=STEEL, gap=Paraboloid(460, 300), Fn=5e4,
    friction=Friction(0.3, rolling=Rolling(xi=1e-3, phi=2e-4)),
)  # fmt: skip


@pytest.fixture(scope="module")
def client():
    with contactd.local(in_process=True) as opened:
        yield opened


@pytest.fixture(scope="module")
def rolling(client):
    return client.solve(PROBLEM)


@pytest.fixture(autouse=True)
def no_figure_left():
    yield
    plt.close("all")


def drawn(axes):
    """Returns the texts of a picture after it was drawn."""
    axes.figure.canvas.draw()
    for shown in axes.figure.axes:
        if shown.get_legend() is not None:
            inside, whole = shown.get_legend().get_window_extent(), axes.figure.bbox
            assert min(inside.x0, inside.y0) > -1, "no legend is cut off"
            assert (inside.x1, inside.y1) < (whole.x1 + 1, whole.y1 + 1), "no legend is cut off"
            if inside.y0 < shown.bbox.y0:  # below the axes
                assert inside.y1 <= shown.xaxis.get_tightbbox().y0, "no legend lies over the axis"
    legend = axes.get_legend()
    texts = [] if legend is None else [text.get_text() for text in legend.get_texts()]
    return [axes.get_title(), axes.get_xlabel(), axes.get_ylabel(), *texts]


def test_a_contact_is_drawn_with_its_edges_and_tractions(rolling):
    title, x, y, *legend = drawn(rolling.plot())
    assert title.startswith("$F_n$ = 50000 N, $F_x$ = -")
    assert (x, y) == ("x (mm)", "y (mm)")
    assert {"edge of contact", "edge of adhesion"} < set(legend)
    assert any("up to " in text and text.endswith("N/mm$^2$") for text in legend)


def test_the_map_lies_where_the_grid_lies(rolling):
    (image,) = rolling.plot().get_images()
    assert image.get_extent() == pytest.approx((-8, 8, -6, 6))
    assert image.get_array().shape == rolling.pressure.shape
    assert np.ma.count_masked(image.get_array()) == (rolling.pressure == 0).sum()


def test_a_section_shows_the_row_that_was_asked_for(rolling):
    axes = rolling.plot_section(y=2.4)
    assert "along x at y = 2.5 mm" in drawn(axes)[0]
    pressure = next(line for line in axes.lines if line.get_label() == "pressure")
    assert (pressure.get_ydata() == rolling.pressure[8]).all()
    with pytest.raises(ValueError, match=r"y is 9; the grid reaches from -6 to 6 mm"):
        rolling.plot_section(y=9)


@pytest.mark.parametrize(("a", "b"), [(3, 3), (9, 3), (10.5, 2.8), (14, 2), (2.8, 10.5), (2, 14)])
def test_long_patches_have_their_legends_and_arrows_in_place(client, a, b):
    long = PROBLEM.replace(grid=Grid.centred(24, 22, 2.2 * a, 2.2 * b), gap=SemiAxes(a, b))
    drawn(axes := long_picture(client, long))
    (arrows,) = (one for one in axes.collections if type(one).__name__ == "Quiver")
    x, y = (np.abs(reach / arrows.scale) for reach in (arrows.U, arrows.V))
    # No arrow is longer than a quarter of the picture.
    assert x.max() < 0.25 * np.ptp(axes.get_xlim()) and y.max() < 0.25 * np.ptp(axes.get_ylim())


def long_picture(client, problem):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return client.solve(problem).plot()


def test_without_friction_there_are_no_arrows(client):
    legend = drawn(client.solve(PROBLEM.replace(friction=None)).plot())[3:]
    assert legend == ["edge of contact"]


def test_pictures_are_drawn_into_the_axes_that_are_given(rolling, client):
    _, panels = plt.subplots(1, 3)
    table = client.get_ic(STEEL, Grid(8, 6, 1, 1), AnalyticIcs())
    assert rolling.plot(panels[0]) is panels[0]
    assert rolling.plot_section(axes=panels[1]) is panels[1]
    assert table.plot(axes=panels[2]) is panels[2]
    assert len(plt.get_fignums()) == 1


def test_arrays_that_were_not_asked_for_are_named(client):
    with pytest.raises(ValueError, match="The solution has no pressure, element_division: include it in `fields`"):
        client.solve(PROBLEM, fields=[]).plot()
    partial = client.solve(PROBLEM, fields=["pressure", "element_division"])
    assert "edge of contact" in drawn(partial.plot())


def test_steps_and_patches_know_their_grid(client):
    with client.session(PROBLEM) as session:
        step = session.step(fields=["pressure", "element_division"])
        assert step.grid == PROBLEM.grid
        assert drawn(step.plot())


def test_a_table_is_drawn_over_the_distance(client):
    table = client.get_ic(STEEL, Grid(8, 6, 0.5, 1), AnalyticIcs())
    axes = table.plot(["zz", "xz"])
    assert drawn(axes)[1:] == [
        "distance from the loaded element (mm)", "displacement by a unit traction (mm$^3$/N)",
        "|zz| along x", "|zz| along y", "|xz| along x",
    ]  # fmt: skip
    assert axes.get_yscale() == "log"
    assert axes.lines[0].get_xdata()[-1] == 3.5
    with pytest.raises(KeyError, match="'zw' is not a component"):
        table.plot(["zw"])


@pytest.fixture(scope="module")
def block(client, rolling):
    z = -np.linspace(0, 6, 7)
    return client.subsurface(PROBLEM, rolling, block=StressBlock(PROBLEM.grid.x, PROBLEM.grid.y, z))


def test_a_stress_is_drawn_on_a_plane(block):
    title, x, y, *_ = drawn(block.plot())
    assert title.startswith("Von Mises stress at y = ")
    assert (x, y) == ("x (mm)", "z (mm); negative inside the body")
    assert drawn(block.plot("xz", z=-2.1))[0] == "Stress xz at z = -2 mm"
    assert drawn(block.plot(x=0, y=0))[:2] == ["Von Mises stress at x = 0 mm, y = -0.5 mm", "z (mm)"]


def test_a_stress_that_cannot_be_drawn_says_why(block, client, rolling):
    with pytest.raises(ValueError, match="a single point, which cannot be drawn"):
        block.plot(x=0, y=0, z=0)
    with pytest.raises(ValueError, match="component is 'mises'; it must be"):
        block.plot("mises")
    points = client.subsurface(PROBLEM, rolling, points=[[0, 0, -1]])
    assert points.points.shape == (1, 3)
    with pytest.raises(ValueError, match="requires those of a StressBlock"):
        points.plot()


def test_creep_curves_name_their_series(client):
    xs = [1e-4, 5e-4, 2e-3]
    problems = [PROBLEM.replace(friction=Friction(0.3, rolling=Rolling(xi=xi, phi=2e-4)), model="fastsim") for xi in xs]
    solutions = client.solve_many(problems, fields=[])
    axes = plot_creep_curves({"fastsim": solutions})
    assert drawn(axes) == [
        "Creep forces over the longitudinal creepage", "longitudinal creepage", "force over normal force",
        "$-F_x/F_n$, fastsim", "$-F_y/F_n$, fastsim",
    ]  # fmt: skip
    assert list(axes.lines[0].get_xdata()) == xs
    assert list(axes.lines[0].get_ydata()) == [-s.Fx / s.Fn for s in solutions]
    assert drawn(plot_creep_curves(solutions, creepages=[1, 2, 3]))[3] == "$-F_x/F_n$"
    with pytest.raises(ValueError, match='by is \'chi\'; it must be "xi", "eta" or "phi"'):
        plot_creep_curves(solutions, "chi")
    with pytest.raises(ValueError, match=r"solutions\[0\] has no creepage"):
        plot_creep_curves([client.solve(PROBLEM.replace(friction=None))])


def test_a_history_keeps_the_runs_of_each_stage():
    history = ConvergenceHistory()
    for stage, iteration, residual in [("mesh", 0, 0), ("pcg", 1, 1), ("pcg", 2, 0.1), ("pcg", 2, 0.1), ("pcg", 1, 0.5), ("x", 3, 1)]:
        history(Progress(stage, 0.5, iteration=iteration, residual=residual))
    assert history.stages == {"pcg": [[(1, 1), (2, 0.1)], [(1, 0.5)]], "x": [[(3, 1)]]}
    assert drawn(history.plot()) == ["Convergence", "iteration", "relative residual", "pcg", "x"]
    assert drawn(ConvergenceHistory().plot())[0] == "Convergence"


def test_a_wheel_on_a_rail_is_one_figure(client):
    velocity = WheelsetVelocity(x=20e3, pitch=-20e3 / 460)
    setup = WheelRailSetup(dx=0.5, dy=0.5)
    state = WheelRailState(position=WheelsetPosition(y=3), velocity=velocity, Fz=8e4)
    for fields, panels in ((None, 2), ([], 1)):
        figure = client.wheel_rail(setup, state, fields=fields).plot()
        shown = [axes for axes in figure.axes if axes.get_title()]
        assert [axes.get_title() for axes in shown] == ["Contacts, and forces on the rail", "Contact 1, on the rail"][:panels]
        assert drawn(shown[0])[1:3] == ["y of the track (mm)", "z of the track (mm), down"]
        assert "Fz 80 kN" in figure.get_suptitle()
        wheel, rail = (line for line in shown[0].lines if len(line.get_xdata()) > 100)
        y = np.mean(next(line for line in shown[0].lines if line.get_linewidth() == 4).get_xdata())
        heights = [np.interp(y, *np.transpose(sorted(zip(*line.get_data())))) for line in (wheel, rail)]
        assert heights[0] == pytest.approx(heights[1], abs=0.3), "wheel and rail meet where they touch"
    high = client.wheel_rail(setup, WheelRailState(position=WheelsetPosition(z=-9), velocity=velocity))
    assert "no contact" in [text.get_text() for text in high.plot().axes[0].texts]


def test_matplotlib_is_imported_with_the_first_picture_only():
    code = "import sys, contactd, contactd.pictures; assert not {'matplotlib', 'asyncio', 'rich', 'h5py'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_a_picture_without_matplotlib_says_what_to_install(monkeypatch, rolling):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.delitem(sys.modules, "matplotlib.pyplot")
    with pytest.raises(MissingExtra, match=r'A picture needs matplotlib: pip install "contactd\[pictures\]"'):
        rolling.plot()


def test_models_are_drawn_side_by_side(client):
    compared = client.compare(PROBLEM, models=["fastsim", "kpec+full", "hertz"], repeats=1)
    figure = compared.plot()
    titles = [axes.get_title() for axes in figure.findobj(matplotlib.axes.Axes) if axes.get_visible()]
    assert [title for title in titles if title in ("full", "fastsim", "kpec+full", "hertz")] == ["full", "fastsim", "kpec+full"]
    forces, costs = (axes for axes in figure.findobj(matplotlib.axes.Axes) if axes.get_title().startswith(("Tangential", "Errors")))
    assert forces.get_xlabel() == "$F_x$ (kN)"
    assert "% of $\\mu F_n$" in costs.get_ylabel()
    assert [text.get_text() for text in costs.get_legend().get_texts()] == ["full", "fastsim", "kpec+full"]
    expected = [one.solution.Fx / 1e3 for one in compared.computed]
    assert [line.get_xdata()[0] for line in forces.lines] == expected


def test_a_force_that_is_rounding_only_has_no_axis_of_its_own(client):
    figure = client.compare(PROBLEM.replace(friction=Friction(mu=0.3, rolling=Rolling(xi=1e-3))), models=["kpec+full"], repeats=1).plot()
    (forces,) = (axes for axes in figure.findobj(matplotlib.axes.Axes) if axes.get_title().startswith("Tangential"))
    assert [line.get_ydata()[0] for line in forces.lines] == [0, 0]
    low, high = forces.get_ylim()
    assert high - low > 1e-3


def test_a_contact_of_few_elements_is_seen_whole(client):
    coarse = PROBLEM.replace(grid=Grid.centred(8, 8, 40, 40))
    compared = client.compare(coarse, models=["full"], repeats=1)
    (panel,) = (axes for axes in compared.plot().findobj(matplotlib.axes.Axes) if axes.get_title() == "full")
    grid, pressure = coarse.grid, compared.computed[0].solution.pressure
    _, columns = np.nonzero(pressure > 0)
    left, right = grid.x[columns.min()] - grid.dx / 2, grid.x[columns.max()] + grid.dx / 2
    assert panel.get_xlim()[0] < left < right < panel.get_xlim()[1]


def test_a_wheel_without_contact_is_drawn_by_all_models(client):
    state = WheelRailState(position=WheelsetPosition(z=-5))
    figure = client.compare_wheel_rail(WheelRailSetup(dx=1, dy=1, friction=None), state, repeats=1).plot()
    assert any(axes.get_title() == "Areas and pressures" for axes in figure.findobj(matplotlib.axes.Axes))

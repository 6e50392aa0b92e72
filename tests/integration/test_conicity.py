"""Tests rigid wheelsets on rigid rails with wheelrail.geometry, against closed forms and the page."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from contactd import Client, ContactWarning, InvalidArgument, TimeoutExpired
from contactd.wheel_rail import ArcProfile, ConeProfile, ProfilePoints, Rail60E1, Track, WheelRailSetup, Wheelset

PAGE = Path(__file__).parents[2] / "docs" / "profiles.md"
PLAIN = WheelRailSetup()
CONE = WheelRailSetup(wheel=ConeProfile(-0.05, ends=(-60, 60)))


def head(inclination: float) -> np.ndarray:
    """Returns points of a head with R 300 on top and corners of 13 mm, inclined towards y < 0."""
    y = np.linspace(-36, 36, 73)
    z = np.where(abs(y) < 23, y**2 / 600, 0.88 + 13 - np.sqrt(np.maximum(169 - (abs(y) - 23) ** 2, 0)))
    points = np.vstack([(-36, 30), np.column_stack([y, z]), (36, 30)])
    cosine, sine = math.cos(inclination), math.sin(inclination)
    return points @ np.array([[cosine, -sine], [sine, cosine]])


HEAD = head(1 / 40)
MIRRORED = ProfilePoints(HEAD * (-1, 1))


def rows_of_page() -> list[tuple[float, list[tuple[float, float]]]]:
    """Returns amplitude, and integrated and harmonic conicities of the columns."""
    cell = r" ([\d.]+) \(([\d.]+)\) \|"
    found = re.findall(rf"^\| (\d) \|{4 * cell}$", PAGE.read_text(), re.MULTILINE)
    return [
        (float(a), [(float(i), float(h)) for i, h in zip(cells[::2], cells[1::2], strict=True)]) for a, *cells in found
    ]


def test_a_cone_of_1_in_20_has_a_conicity_of_0_05(shared):
    for conicity in shared.equivalent_conicity(CONE, [1, 3, 8]):
        assert conicity.integrated == pytest.approx(0.05, abs=1e-9)
        assert conicity.harmonic == pytest.approx(0.05, abs=1e-9)
        assert conicity.wavelength == pytest.approx(2 * math.pi * math.sqrt(750 * 460 / 0.05), rel=1e-8)  # Klingel
    contacts = shared.wheelset_contacts(CONE, [-3, 0, 3])
    assert [one.radius_difference for one in contacts] == pytest.approx([-0.3, 0, 0.3], abs=1e-6)
    assert contacts[1].left.y == -contacts[1].right.y


@pytest.mark.parametrize(
    ("column", "inclination", "roll"),
    [(0, 1 / 40, "neglected"), (1, 1 / 40, "demanded"), (2, 1 / 20, "neglected"), (3, 1 / 20, "demanded")],
)
def test_s1002_on_60e1_has_the_conicities_of_the_page(shared, column, inclination, roll):
    rows = rows_of_page()
    assert [amplitude for amplitude, _ in rows] == list(range(1, 9))
    setup = WheelRailSetup(rail=Rail60E1(inclination))
    found = shared.equivalent_conicity(setup, [amplitude for amplitude, _ in rows], roll=roll)
    for (amplitude, columns), conicity in zip(rows, found, strict=True):
        integrated, harmonic = columns[column]
        digit = 1e-4 if integrated < 0.01 else 1e-3
        assert conicity.amplitude == amplitude
        assert conicity.integrated == pytest.approx(integrated, abs=0.51 * digit)
        assert conicity.harmonic == pytest.approx(harmonic, abs=0.51 * digit)


def test_the_points_of_the_contacts_lie_on_the_profiles(shared):
    shifts = np.linspace(-7, 7, 15)
    profiles, all_contacts = shared.placed_profiles(PLAIN), shared.wheelset_contacts(PLAIN, shifts)
    for side, outwards in (("left", -1), ("right", 1)):
        placed = getattr(profiles, side)
        for shift, contacts in zip(shifts, all_contacts, strict=True):
            contact = getattr(contacts, side)
            assert outwards * contact.y == pytest.approx(placed.rail_origin.y + contact.rail_y, abs=1e-9)
            # Straight lines between the points differ from the curve by micrometres, and vertically by more where it
            # is steep.
            on_rail = np.interp(contact.rail_y, *placed.rail.T)
            assert contact.z - placed.rail_origin.z == pytest.approx(on_rail, abs=1e-2)
            assert outwards * (contact.y - shift) == pytest.approx(placed.wheel_origin + contact.wheel_y, abs=1e-9)
            assert contact.radius == pytest.approx(460 + np.interp(contact.wheel_y, *placed.wheel.T), abs=1e-2)


def test_shifts_to_both_sides_mirror_each_other(shared):
    there, back = shared.wheelset_contacts(PLAIN, [4.3, -4.3], roll="demanded")
    assert there.roll == pytest.approx(-back.roll, abs=1e-12)
    assert there.roll != 0
    assert (there.right.radius, there.right.y) == pytest.approx((back.left.radius, -back.left.y), abs=1e-7)


def test_sides_may_differ(shared):
    left = CONE.replace(rail=Rail60E1(1 / 20))
    (mixed,), (plain,), (cone,) = (
        shared.wheelset_contacts(PLAIN, [1], left=left),
        shared.wheelset_contacts(PLAIN, [1]),
        shared.wheelset_contacts(left, [1]),
    )
    assert mixed.right == plain.right
    assert mixed.left == cone.left
    profiles = shared.placed_profiles(PLAIN, left=left)
    assert len(profiles.left.wheel) != len(profiles.right.wheel)
    (swinging,) = shared.equivalent_conicity(PLAIN, [3], left=left)
    assert swinging.integrated != shared.equivalent_conicity(PLAIN, [3])[0].integrated


def test_wheels_of_unequal_radii_roll_alike_beside_the_middle(shared):
    """Uses cones of 1/20: a displacement by 10 mm compensates 1 mm on the left one."""
    left = CONE.replace(wheelset=Wheelset(nominal_radius=459))
    (contact,) = shared.wheelset_contacts(CONE, [-10], left=left)
    assert contact.radius_difference == pytest.approx(0, abs=1e-6)
    assert shared.wheelset_contacts(CONE, [0], left=left)[0].radius_difference == pytest.approx(1, abs=1e-6)
    for conicity in shared.equivalent_conicity(CONE, [1, 3], left=left):
        assert conicity.integrated == pytest.approx(0.05, abs=1e-6)
        assert conicity.wavelength == pytest.approx(2 * math.pi * math.sqrt(750 * 459.5 / 0.05), rel=1e-6)


def test_cylinders_have_no_conicity(shared):
    (conicity,) = shared.equivalent_conicity(WheelRailSetup(wheel=ConeProfile(0.0, ends=(-60, 60))), [3])
    assert (conicity.integrated, conicity.harmonic, conicity.wavelength) == (0, 0, None)


def test_a_motion_that_does_not_swing_back_has_no_conicity(shared):
    setup = WheelRailSetup(
        wheel=ConeProfile(0.05, ends=(-60, 60)), rail=ArcProfile(300), track=Track(rail_origin=(750, 0))
    )
    (conicity,) = shared.equivalent_conicity(setup, [2])
    assert (conicity.integrated, conicity.harmonic, conicity.wavelength) == (None, None, None)


@pytest.mark.parametrize(
    ("setup", "asked", "field"),
    [
        ({}, {"amplitudes": []}, "conicity.amplitudes"),
        ({}, {"amplitudes": [3, 0]}, "conicity.amplitudes[1]"),
        ({}, {"amplitudes": [math.nan]}, "conicity.amplitudes"),
        ({}, {"amplitudes": [1] * 101}, "conicity.amplitudes"),
        ({}, {"amplitudes": [3], "roll": "free"}, "conicity.roll"),
        ({}, {"amplitudes": [3], "contact_distance": -1500}, "conicity.contact_distance"),
        ({}, {"amplitudes": [3], "tolerance": 0}, "conicity.tolerance"),
        ({"track": Track(gauge=60)}, {"amplitudes": [3]}, "setup.track.gauge"),
        ({"track": Track(roller_radius=500)}, {"amplitudes": [3]}, "setup.track.roller_radius"),
        ({}, {"amplitudes": [3], "left": CONE.replace(track=Track(roller_radius=500))}, "left.track.roller_radius"),
        ({"track": Track(gauge=1600)}, {"amplitudes": [3]}, "conicity.amplitudes"),
        ({"wheelset": Wheelset(nominal_radius=0)}, {"amplitudes": [3]}, "setup.wheelset.nominal_radius"),
        ({"wheel": ConeProfile(-0.05, ends=(-4, 4))}, {"amplitudes": [6]}, "conicity.amplitudes"),
        ({"rail": ArcProfile(300, ends=(-5, 5))}, {"amplitudes": [10]}, "conicity.amplitudes"),
        ({"rail": ProfilePoints([[0, 0]])}, {"amplitudes": [3]}, "setup.rail.points"),
        ({}, {"amplitudes": [3], "left": CONE.replace(wheel=ArcProfile(10))}, "left.wheel.arc"),
        ({}, {"amplitudes": [3], "left": CONE.replace(rail=ProfilePoints([[0, 0]]))}, "left.rail.points"),
        ({}, {"shifts": [0, math.inf]}, "contacts.shifts"),
        ({}, {"shifts": [0, 300]}, "contacts.shifts[1]"),
        ({}, {"shifts": [0] * 1001}, "contacts.shifts"),
        ({}, {"shifts": []}, "contacts.shifts"),
        ({"rail": Rail60E1(3)}, {"shifts": [0]}, "setup.rail.rail_60e1.inclination"),
    ],
)
def test_bad_input_is_named_by_its_field(shared_daemon, setup, asked, field):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        method = client.wheelset_contacts if "shifts" in asked else client.equivalent_conicity
        method(PLAIN.replace(**setup), **asked)
    assert caught.value.violations[0].field.startswith(field), caught.value


@pytest.mark.parametrize(
    ("setup", "asked", "sentence"),
    [
        ({}, {"amplitudes": [0.01, 0.03]}, "conicity.amplitudes are at most 0.03 mm"),
        ({}, {"amplitudes": [3], "contact_distance": 1.5}, "conicity.contact_distance is 1.5 mm"),
        ({}, {"shifts": [-0.006, 0, 0.006]}, "contacts.shifts are at most 0.006 mm"),
        ({"rail": MIRRORED}, {"amplitudes": [3]}, "appears to have its gauge side at y > 0"),
        ({"rail": MIRRORED}, {"shifts": [0]}, "appears to have its gauge side at y > 0"),
        ({}, {"amplitudes": [3], "left": PLAIN.replace(rail=MIRRORED)}, "appears to have its gauge side at y > 0"),
        ({"rail": ProfilePoints(HEAD * (0.1, 0.1))}, {"amplitudes": [3]}, "mm wide, but 70 mm are usual"),
    ],
)
def test_doubtful_profiles_and_units_are_warned_of(shared, setup, asked, sentence):
    method = shared.wheelset_contacts if "shifts" in asked else shared.equivalent_conicity
    with pytest.warns(ContactWarning, match=re.escape(sentence)):
        method(PLAIN.replace(**setup), **asked)


def test_usual_profiles_and_units_are_not_warned_of(shared, recwarn):
    shared.equivalent_conicity(WheelRailSetup(rail=ProfilePoints(HEAD)), [0.01, 3])
    shared.wheelset_contacts(PLAIN, [0])
    assert not recwarn.list


def test_a_conicity_ends_at_its_deadline(shared):
    setup = WheelRailSetup(rail=Rail60E1(1 / 20))
    with pytest.raises(TimeoutExpired):
        shared.equivalent_conicity(setup, [8], roll="demanded", tolerance=1e-4, timeout=0.1)
    assert shared.equivalent_conicity(CONE, [3])

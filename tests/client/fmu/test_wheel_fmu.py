"""Tests a wheel on its rail as an FMU."""

from __future__ import annotations

import math

import pytest

from support import c_interface

FORCES = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")
COARSE = {"elements.dx": 0.5, "elements.dy": 0.5}
PITCH = -20e3 / 460


def set_up(direct, y):
    direct.set({"setup.dx": 0.5, "setup.dy": 0.5, "state.velocity.x": 20e3, "state.velocity.pitch": PITCH, "state.Fz": 80e3})
    direct.set({"state.position.y": y, "state.position.yaw": 1e-3 * y})


def values_at(y):
    return {"position.y": float(y), "position.yaw": 1e-3 * y, "velocity.pitch": PITCH}


def test_positions_across_the_track_answer_as_the_c_interface_to_the_last_bit(wheel):
    fmu = wheel().start(COARSE)
    with c_interface.wheel() as direct:
        for y in (-3, 0, 2, 5):
            set_up(direct, y)
            direct.solve()
            outputs = fmu.step(values_at(y))
            assert [outputs[name] for name in FORCES] == direct.array("forces.track")
            assert [outputs["z"], outputs["pitch_rate"]] == [direct.get("z"), direct.get("pitch_rate")]
            assert outputs["clearance"] == direct.get("clearance")
            assert outputs["patches"] == direct.get("patches") >= 1
            patches = [f"patches[{patch}]" for patch in range(outputs["patches"])]
            assert outputs["power"] == sum(direct.get(f"{patch}.solution.frictional_power") for patch in patches) > 0
            assert outputs["pmax"] == max(direct.get(f"{patch}.solution.pmax") for patch in patches)
            assert outputs["area.contact"] == sum(direct.get(f"{patch}.solution.area.contact") for patch in patches)
            place, of = direct.array("patches[0].place.reference"), direct.array("patches[0].solution.forces")
            assert [
                outputs[f"patch[1].{name}"] for name in ("x", "y", "z", "angle", "Fn", "Fx", "Fs", "Mn")
            ] == place + of
            assert outputs["converged"]
    assert outputs["Fz"] == pytest.approx(80e3, rel=1e-5)


def test_patches_that_are_gone_leave_no_values_behind(wheel):
    z = wheel(name="by force").start({**COARSE, "model": 2}).step(values_at(0))["z"]
    fmu = wheel().start({**COARSE, "model": 2, "vertical": 1})
    assert fmu.step({**values_at(0), "position.z": z})["patch[1].Fn"] > 0
    apart = fmu.step({"position.z": z - 1})
    assert apart["patches"] == 0
    assert all(value == 0 for name, value in apart.items() if name.startswith(("patch[", "F", "pmax", "area", "power")))
    assert apart["clearance"] > 0
    assert apart["converged"]


def test_forces_are_told_in_the_coordinates_that_are_asked_for(wheel):
    told = [wheel(name=f"in {k}").start({**COARSE, "model": 2, "coordinates": k}).step(values_at(3)) for k in range(3)]
    lengths = [math.hypot(one["Fx"], one["Fy"], one["Fz"]) for one in told]
    assert lengths[1:] == pytest.approx(lengths[:1] * 2, rel=1e-12)
    assert told[0]["My"] != told[2]["My"]


def test_a_left_wheel_mirrors_a_right_one(wheel):
    right = wheel(name="right").start({**COARSE, "model": 2}).step(values_at(2))
    left = (
        wheel(name="left")
        .start({**COARSE, "model": 2, "side": 0})
        .step({"position.y": -2.0, "position.yaw": -2e-3, "velocity.pitch": PITCH})
    )
    assert left["Fx"] == pytest.approx(right["Fx"], rel=1e-9)
    assert left["Fy"] == pytest.approx(-right["Fy"], rel=1e-9)


def write_arc(path, radius=300):
    points = [(y / 2, radius - math.sqrt(radius**2 - y * y / 4)) for y in range(-60, 61)]
    path.write_text("".join(f"{y:.17g} {z:.17g}\n" for y, z in points))


ARC = {**COARSE, "model": 2, "wheel.profile": "cone", "track.by_origin": True}


def test_profiles_come_from_a_path_or_the_resources(wheel, tmp_path):
    write_arc(tmp_path / "arc.txt")
    from_path = wheel(name="path").start({**ARC, "rail.profile": str(tmp_path / "arc.txt")}).step(values_at(0))
    fmu = wheel(name="resources")
    write_arc(tmp_path / f"contactd_wheel_fmi{fmu.fmi}" / "resources" / "my rail.txt")
    assert fmu.start({**ARC, "rail.profile": "my rail.txt"}).step(values_at(0)) == from_path
    by_name = wheel(name="arc").start({**ARC, "rail.profile": "arc"}).step(values_at(0))
    assert by_name["patch[1].pmax"] == pytest.approx(from_path["patch[1].pmax"], rel=1e-2)


def test_names_that_lead_out_of_the_resources_are_refused(wheel, refused, tmp_path):
    """They may be links, and lists of slices of the FMU may contain whole paths."""
    fmu = wheel(name="outside")
    resources = tmp_path / f"contactd_wheel_fmi{fmu.fmi}" / "resources"
    write_arc(resources.parent / "secret.txt")
    write_arc(tmp_path / "secret.txt")
    (resources / "link.txt").symlink_to(tmp_path / "secret.txt")
    for at, name in enumerate(("../secret.txt", "..\\secret.txt", "rails/../../secret.txt", "file:../secret.txt", "link.txt")):
        (resources / "rails").mkdir(exist_ok=True)
        outside = wheel(name=f"outside {at}")
        outside.enter({**ARC, "rail.profile": name})
        refused(outside, outside.slave.exitInitializationMode, "leads out of")
    for at, name in enumerate(("../../secret.txt", str(tmp_path / "secret.txt"))):
        (resources / "rails" / "list.txt").write_text(f"0 {name}\n100 {name}\n")
        listed = wheel(name=f"list {at}")
        listed.enter({**COARSE, "rail.slices": "rails/list.txt"})
        refused(listed, listed.slave.exitInitializationMode, "secret.txt", "resources")


def test_names_of_profiles_are_taken_as_they_are_meant(wheel, tmp_path):
    """Names may have any case, spaces, URIs, and slashes of other systems."""
    usual = wheel(name="usual").start(COARSE).step(values_at(1))
    for at, names in enumerate((("s1002", "60e1"), (" S 1002 ", "60 E1"), ("S1002\n", "60E1 "), ("S1002", "uic60"))):
        told = dict(zip(("wheel.profile", "rail.profile"), names, strict=True))
        assert wheel(name=f"names {at}").start({**COARSE, **told}).step(values_at(1)) == usual
    assert wheel(name="54E1").start({**COARSE, "rail.profile": "54 e1"}).step(values_at(1)) != usual
    folder = tmp_path / "my profiles"
    folder.mkdir()
    write_arc(folder / "rail 1.txt")
    fmu = wheel(name="path")
    resources = tmp_path / f"contactd_wheel_fmi{fmu.fmi}" / "resources" / "rails"
    resources.mkdir()
    write_arc(resources / "rail 1.txt")
    path = str(folder / "rail 1.txt")
    from_path = fmu.start({**ARC, "wheel.profile": "Cone", "rail.profile": path}).step(values_at(0))
    uri = path.replace(" ", "%20")
    for at, name in enumerate((
        f"file://{uri}", f"file://localhost{uri}", f"FILE:{uri}", f"file://{path}", f" {path} ", path.replace("/", "\\"),
        "rails/rail 1.txt", "rails\\rail 1.txt", "file:rails/rail%201.txt",
    )):  # fmt: skip
        assert wheel(name=f"place {at}").start({**ARC, "rail.profile": name}).step(values_at(0)) == from_path, name


def test_no_friction_no_forces_along_the_track(wheel):
    outputs = wheel().start({**COARSE, "model": 2, "friction.none": True}).step(values_at(2))
    assert outputs["patch[1].Fx"] == outputs["power"] == 0
    assert outputs["Fz"] == pytest.approx(80e3, rel=1e-5)


def test_derivatives_are_those_of_the_c_interface(wheel):
    z = wheel(name="by force").start({**COARSE, "model": 2}).step(values_at(1))["z"]
    fmu = wheel().start({**COARSE, "model": 2, "vertical": 1})
    position = {**values_at(1), "position.z": z}
    before = fmu.step(position)
    names = [f"position.{part}" for part in ("y", "z", "roll", "yaw")]
    names += [f"velocity.{part}" for part in ("x", "y", "z", "roll", "yaw", "pitch")]
    told = {name: fmu.derivatives(FORCES, name) for name in names}
    assert fmu.outputs() == before
    with c_interface.wheel() as direct:
        set_up(direct, 1)
        direct.clear("state.Fz")
        direct.set_word("setup.model", "fastsim")
        direct.set({"state.position.z": z, "state.derivatives": 1})
        direct.solve()
        assert told == {name: direct.array(f"derivatives.{name}") for name in names}
    step = fmu.step(position)
    assert step == before


def test_ten_wheels_at_once_do_not_meet(wheel):
    several = [wheel(name=f"wheel {k}").start({**COARSE, "model": 2}) for k in range(10)]
    alone = [wheel(name="alone").start({**COARSE, "model": 2}).step(values_at(0.5 * k))["Fy"] for k in range(10)]
    for _ in range(2):
        assert [fmu.step(values_at(0.5 * k))["Fy"] for k, fmu in enumerate(several)] == alone
    assert len(set(alone)) == 10


def test_derivatives_under_a_force_hold_the_force(wheel):
    """The height is excluded, which differs between adjacent steps."""
    fmu = wheel().start({**COARSE, "model": 2, "tolerances.force": 1e-10})
    position = {**values_at(1), "load.Fz": 80e3}
    fmu.step(position)
    told = {name: fmu.derivatives(FORCES, name) for name in ("position.yaw", "velocity.pitch", "load.Fz", "position.z")}
    steps = {"position.yaw": 1e-5, "velocity.pitch": 1e-3, "load.Fz": 10.0}
    for name, h in steps.items():
        more, less = (fmu.step({**position, name: position[name] + sign * h}) for sign in (1, -1))
        measured = [(more[one] - less[one]) / (2 * h) for one in FORCES]
        assert told[name] == pytest.approx(measured, rel=0.03, abs=0.01 * max(map(abs, measured))), name
    assert told["load.Fz"][2] == pytest.approx(1, rel=1e-9)
    assert told["position.z"] == [0] * 6


def test_a_massless_flexible_rail_deflects_by_its_load_over_its_stiffness(wheel):
    fmu = wheel().start({**COARSE, "track.springs.z": 1e5, "track.springs.y": 2e4})
    outputs = fmu.step({**values_at(0), "rail.Fy": -500.0, "rail.Fz": 2e3})
    assert outputs["rail_deflection.z"] == pytest.approx((80e3 + 2e3) / 1e5, rel=1e-5)
    assert outputs["rail_deflection.y"] == pytest.approx((outputs["Fy"] - 500) / 2e4, rel=1e-3)


def test_friction_follows_the_angle_of_the_rail(wheel):
    angles = {"friction.angle[1]": -0.8, "friction.mu_at[1]": 0.1, "friction.angle[2]": -0.2, "friction.mu_at[2]": 0.3}
    fmu = wheel().start({**COARSE, "friction.angles": 2, "friction.along_profile": True, **angles})
    outputs = fmu.step(values_at(7))
    with c_interface.wheel() as direct:
        set_up(direct, 7)
        for k, (angle, mu) in enumerate(((-0.8, 0.1), (-0.2, 0.3))):
            direct.set({f"setup.friction.mu[{k}].angle": angle, f"setup.friction.mu[{k}].mu": mu})
        direct.set({"setup.friction.along_profile": 1})
        direct.solve()
        assert [outputs[name] for name in FORCES] == direct.array("forces.track")
    assert outputs["Fx"] != wheel(name="everywhere").start(COARSE).step(values_at(7))["Fx"]


def test_an_out_of_round_wheel_goes_down_over_its_flat(wheel, tmp_path):
    depths = {-0.1: 0, -0.05: 0, -0.03: 0.3, 0: 0.5, 0.03: 0.3, 0.05: 0, 0.1: 0}
    for k, depth in enumerate(depths.values()):
        (tmp_path / f"slice {k}.txt").write_text(f"-40 {-depth}\n0 {-depth}\n40 {-depth}\n")
    flat = tmp_path / "flat.txt"
    flat.write_text("".join(f"{angle} slice {k}.txt\n" for k, angle in enumerate(depths)) + "\n")
    slices = {"wheel.slices": str(flat), "wheel.mirror_z_number": 1}  # flat lines do not show the direction of z
    fmu = wheel().start({**COARSE, "model": 2, "rail.profile": "arc", "track.by_origin": True, **slices})
    on_flat, beside = (fmu.step({**values_at(0), "position.pitch": pitch}) for pitch in (0.0, 1.0))
    assert on_flat["z"] > beside["z"] + 0.3
    with c_interface.wheel() as direct:
        set_up(direct, 0)
        direct.set_word("setup.model", "fastsim")
        direct.set({"setup.rail.arc.radius": 300, "setup.track.rail_origin.y": 750, "setup.track.rail_origin.z": 0})
        for k, (angle, depth) in enumerate(depths.items()):
            direct.set({f"setup.wheel_slices[{k}].angle": angle})
            for at, y in enumerate((-40, 0, 40)):
                point = f"setup.wheel_slices[{k}].profile.points[{at}]"
                direct.set({f"{point}.y": y, f"{point}.z": -depth})
        direct.solve()
        assert [on_flat[name] for name in FORCES] == direct.array("forces.track")


@pytest.mark.parametrize(
    ("lines", "sentence"), [("0.1\n", "must have a number and the file"), ("\n0.1 nothing.txt\n", "line 2")]
)
def test_a_list_of_slices_that_is_wrong_is_refused_by_its_line(wheel, refused, tmp_path, lines, sentence):
    (tmp_path / "list.txt").write_text(lines)
    fmu = wheel()
    fmu.enter({**COARSE, "wheel.slices": str(tmp_path / "list.txt")})
    refused(fmu, fmu.slave.exitInitializationMode, "wheel.slices", sentence)


def test_more_angles_of_friction_than_there_are_are_refused(wheel, refused):
    fmu = wheel()
    fmu.enter({**COARSE, "friction.angles": 7})
    refused(fmu, fmu.slave.exitInitializationMode, "friction.angles", "0 to 6")


def test_fields_are_those_of_the_c_interface_to_the_last_bit(wheel):
    fmu = wheel().start({**COARSE, "patches.distance_combine": 2.0, "track.springs.z": 1e5})
    outputs = fmu.step({**values_at(5), "position.pitch": 0.4})
    with c_interface.wheel() as direct:
        set_up(direct, 5)
        direct.set({"setup.patches.distance_combine": 2, "setup.track.springs.z": 1e5, "state.position.pitch": 0.4})
        direct.solve()
        assert [outputs[name] for name in FORCES] == direct.array("forces.track")
        assert outputs["rail_deflection.z"] == direct.get("rail_deflection.z")


def test_temperatures_of_rail_and_wheel_are_those_of_the_hottest_patch(wheel):
    fmu = wheel().start({**COARSE, "temperature.computed": True})
    outputs = fmu.step({**values_at(2), "temperature.lower.bulk_temperature": 120.0})
    with c_interface.wheel() as direct:
        set_up(direct, 2)
        direct.set({"setup.temperature.upper.bulk_temperature": 0, "setup.temperature.lower.bulk_temperature": 120})
        direct.solve()
        patches = [f"patches[{patch}].solution" for patch in range(int(direct.get("patches")))]
        assert outputs["temperature.largest"] == max(direct.get(f"{patch}.temperature.largest") for patch in patches) > 60
        assert outputs["temperature.heat_lower"] == sum(direct.get(f"{patch}.temperature.heat_lower") for patch in patches)
        assert outputs["power"] == sum(direct.get(f"{patch}.frictional_power") for patch in patches)

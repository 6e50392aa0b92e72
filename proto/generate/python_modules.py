"""Modules of client/python/contactd/values/generated and their parts of the schemas. A module follows those that it uses."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Module:
    """Describes a module of values. `name` is its path. `roots` are pointers to the schemas that it declares, with the
    classes that these use; for a schema with several classes, the name of the class follows a space. `aliases` are
    additional names of types. If `is_asked` is true, the module belongs to requests, and its docstrings state
    ranges."""

    name: str
    says: str
    roots: tuple[str, ...]
    aliases: dict[str, str] = field(default_factory=dict)
    is_asked: bool = False


MODULES = [
    Module(
        "service",
        "Information about a daemon, its jobs and its sessions.",
        (
            "progress.json#/properties/progress",
            "server.info.result.json#",
            "job.list.result.json#/properties/jobs/items",
            "session.list.result.json#/properties/sessions/items",
        ),
    ),
    Module(
        "grid",
        "The potential contact area, and undeformed distances, such as the paraboloid of a Hertzian contact.",
        (
            "definitions.json#/definitions/grid",
            "contact.solve.params.json#/properties/gap/properties/paraboloid",
            "contact.solve.params.json#/properties/gap/properties/semi_axes",
            "contact.solve.params.json#/properties/gap/properties/half_ellipses",
        ),
        is_asked=True,
    ),
    Module(
        "materials",
        "Materials, layers and bodies. Any consistent system of units works; the docstrings assume N and mm.",
        (
            "definitions.json#/definitions/material",
            "definitions.json#/definitions/body/properties/rigid",
            "definitions.json#/definitions/body/properties/viscoelastic",
            "definitions.json#/definitions/ics/properties/layers/items",
            "definitions.json#/definitions/ics LayeredBody",
        ),
        is_asked=True,
    ),
    Module(
        "profile_shapes",
        "Profiles of wheels and rails. They are those of the right side, also of a left wheel: y to the field side, z down, the "
        "flange of a wheel and the gauge face of a rail at y < 0 (mm).",
        (
            "definitions.json#/definitions/profile/properties/s1002",
            "definitions.json#/definitions/profile/properties/rail_60e1",
            "definitions.json#/definitions/profile/properties/arc",
            "definitions.json#/definitions/profile/properties/cone",
            "definitions.json#/definitions/profile/properties/standard",
            "definitions.json#/definitions/profile",
            "definitions.json#/definitions/profile/properties/file",
        ),
        {"Profile": "S1002 | Rail60E1 | ArcProfile | ConeProfile | StandardProfile | ProfilePoints | ProfileFile"},
        is_asked=True,
    ),
    Module(
        "fem_ics",
        "Requests for finite-element tables of influence coefficients.",
        ("definitions.json#/definitions/ics FemIcs",),
        is_asked=True,
    ),
    Module(
        "ics",
        "Origins of influence coefficients.",
        ("definitions.json#/definitions/ics/properties/line_contact", "definitions.json#/definitions/ics AnalyticIcs"),
        {"Ics": "AnalyticIcs | FemIcs"},
        is_asked=True,
    ),
    Module(
        "evidence",
        "Models and settings of solvers for contact problems, and evidence of the accuracy of solutions and "
        "of tables of influence coefficients.",
        (
            "definitions.json#/definitions/wheel_rail_setup/properties/model",
            "definitions.json#/definitions/normal_model",
            "definitions.json#/definitions/simplified",
            "definitions.json#/definitions/solver_settings",
            "contact.solve.params.json#/properties/settings/properties/tangential",
            "definitions.json#/definitions/solver_evidence",
            "definitions.json#/definitions/ic_evidence",
            "definitions.json#/definitions/ic_use",
            "contact.solve.result.json#/properties/evidence",
        ),
    ),
    Module(
        "motion",
        "Motion of the bodies, a shift or rolling, and the dependence of friction on slip velocity and temperature.",
        (
            "definitions.json#/definitions/rolling",
            "contact.solve.result.json#/properties/motion",
            "contact.solve.params.json#/properties/friction/properties/kinetic",
            "contact.solve.params.json#/properties/friction/properties/temperature",
        ),
        is_asked=True,
    ),
    Module(
        "thermal",
        "Thermal properties of the bodies.",
        ("definitions.json#/definitions/thermal_bodies",),
        is_asked=True,
    ),
    Module(
        "regions",
        "Regions of the potential contact area.",
        ("definitions.json#/definitions/region_limits", "definitions.json#/definitions/contact_regions"),
        is_asked=True,
    ),
    Module(
        "wear_laws",
        "Laws of wear. All coefficients are required.",
        ("definitions.json#/definitions/wear_request",),
        is_asked=True,
    ),
    Module(
        "fatigue",
        "Requests for rolling contact fatigue: strengths and functions with their sources, all of them required.",
        ("definitions.json#/definitions/fatigue_request",),
        is_asked=True,
    ),
    Module(
        "friction",
        "Friction and the motion of the bodies. Slip is that of the upper body relative to the lower one, and is opposite to the "
        "traction on the upper body.",
        ("contact.solve.params.json#/properties/friction",),
        is_asked=True,
    ),
    Module(
        "result",
        "Answers of contacts. Arrays are read-only; copy one to change it.",
        (
            "definitions.json#/definitions/fields/items",
            "definitions.json#/definitions/derivatives_of_answer",
            "definitions.json#/definitions/contact_temperature",
            "definitions.json#/definitions/rolling_resistance",
            "definitions.json#/definitions/contact_wear",
            "definitions.json#/definitions/contact_fatigue",
            "contact.solve.result.json#",
        ),
    ),
    Module(
        "subsurface",
        "Stresses inside the bodies: arguments and answers of `Client.subsurface`.",
        (
            "contact.subsurface.params.json#/properties/block",
            "contact.subsurface.result.json#/properties/largest",
            "contact.subsurface.result.json#",
        ),
    ),
    Module(
        "temperature",
        "Temperatures of both surfaces: answers of `Client.temperature`.",
        ("contact.temperature.result.json#",),
    ),
    Module(
        "records",
        "Records that a daemon keeps: tables in its store, and its last solves.",
        (
            "solves.recent.result.json#/properties/solves/items",
            "solves.pressures.result.json#/properties/patches/items",
            "ic.import.result.json#",
            "ic.list.result.json#/properties/tables/items",
            "ic.list.result.json#/properties/quarantined/items",
        ),
    ),
    Module(
        "problem",
        "Contact problems as immutable values. Any consistent system of units works; the docstrings assume N and "
        "mm. The daemon checks bounds: an invalid value raises InvalidArgument naming the field.",
        (
            "contact.solve.params.json#/properties/previous",
            "contact.solve.params.json#/properties/columns",
            "contact.solve.params.json#",
        ),
        is_asked=True,
    ),
    Module("step_input", "Inputs of a step of a contact.", ("session.step.params.json# StepInput",)),
    Module(
        "wheel_rail/setup",
        "A wheel on a rail: the common part of all steps of a simulation. Lengths are in mm, angles in rad, forces in N on "
        "the rail. None is the daemon's default.",
        ("definitions.json#/definitions/wheel_rail_friction", "definitions.json#/definitions/wheel_rail_setup"),
        is_asked=True,
    ),
    Module(
        "wheel_rail/state",
        "Position and motion of a wheelset. Lengths are in mm, angles in rad, forces in N.",
        ("definitions.json#/definitions/wheel_rail_state", "wheelrail.wheelset.params.json#/properties/state"),
        is_asked=True,
    ),
    Module(
        "wheel_rail/step_input",
        "Inputs of a step of a wheel on its rail.",
        ("session.step.params.json# WheelRailStepInput",),
    ),
    Module(
        "wheel_rail/forces",
        "Forces of wheels on rails, and their derivatives. Forces act on the rail, in N and N mm.",
        (
            "definitions.json#/definitions/wrench",
            "definitions.json#/definitions/wheel_rail_forces",
            "definitions.json#/definitions/wheel_rail_derivatives",
        ),
    ),
    Module(
        "wheel_rail/places",
        "Contact positions of a wheel on its rail, from profiles and positions. Lengths are in mm, angles in rad.",
        (
            "definitions.json#/definitions/contact_reference",
            "definitions.json#/definitions/contact_place",
            "wheelrail.geometry.result.json#/properties/geometries/items",
        ),
    ),
    Module(
        "wheel_rail/rigid_wheelset",
        "A rigid wheelset on rigid rails: the answers of `Client.wheelset_contacts`, `Client.equivalent_conicity` and "
        "`Client.placed_profiles`. Lengths are in mm, angles in rad.",
        (
            "wheelrail.geometry.params.json#/properties/contacts/properties/roll",
            "wheelrail.geometry.result.json#/properties/contacts/items",
            "wheelrail.geometry.result.json#/properties/conicities/items",
            "wheelrail.geometry.result.json#/properties/profiles",
        ),
    ),
    Module(
        "wheel_rail/result",
        "Answers of a wheel on its rail, and of a wheelset. Lengths are in mm, angles in rad, forces in N on the rail.",
        ("wheelrail.solve.result.json#", "wheelrail.wheelset.result.json#"),
    ),
    Module(
        "contact_files",
        "Files of the CONTACT program: answers of `Client.read_contact_file`, `Client.run_contact_file`, "
        "`Client.convert_contact_file` and `Client.read_contact_slices`.",
        (
            "contact_file.read.result.json#/properties/cases/items",
            "contact_file.read.result.json#",
            "contact_file.run.result.json#",
            "contact_file.convert.result.json#",
            "contact_file.slices.result.json#/properties/slices/items",
            "contact_file.slices.result.json#",
        ),
    ),
]

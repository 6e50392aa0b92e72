"""Which module of client/python/contactd/values has which part of the schemas. One comes behind those that it uses."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Module:
    """`name` is its path; `roots` are what it declares, with all that this is made of."""

    name: str
    says: str
    roots: tuple[str, ...]


MODULES = [
    Module(
        "service",
        "What a daemon tells of itself, of its work and of sessions.",
        (
            "progress.json#/properties/progress",
            "server.info.result.json#",
            "job.list.result.json#/properties/jobs/items",
            "session.list.result.json#/properties/sessions/items",
        ),
    ),
    Module(
        "evidence",
        "How a contact problem is solved, and what that is worth: models, settings of the solvers, and evidence of theirs and "
        "of tables of influence coefficients.",
        (
            "definitions.json#/definitions/wheel_rail_setup/properties/model",
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
        "Rolling, and how friction falls with the slip velocity.",
        ("definitions.json#/definitions/rolling", "contact.solve.params.json#/properties/friction/properties/kinetic"),
    ),
    Module(
        "result",
        "What is answered of a contact. Arrays are read-only; copy one to change it.",
        ("definitions.json#/definitions/derivatives_of_answer", "contact.solve.result.json#"),
    ),
    Module(
        "records",
        "What a daemon keeps: tables in its store, and its last solves.",
        (
            "solves.recent.result.json#/properties/solves/items",
            "solves.pressures.result.json#/properties/patches/items",
            "ic.import.result.json#",
            "ic.list.result.json#/properties/tables/items",
            "ic.list.result.json#/properties/quarantined/items",
        ),
    ),
    Module(
        "wheel_rail/setup",
        "A wheel on a rail: what all steps of a simulation have in common. Lengths in mm, angles in rad, forces in N on the "
        "rail. What is None takes the daemon's default.",
        ("definitions.json#/definitions/wheel_rail_friction", "definitions.json#/definitions/wheel_rail_setup"),
    ),
    Module(
        "wheel_rail/state",
        "Where a wheelset is, and how it moves. Lengths in mm, angles in rad, forces in N.",
        ("definitions.json#/definitions/wheel_rail_state", "wheelrail.wheelset.params.json#/properties/state"),
    ),
    Module(
        "wheel_rail/forces",
        "Forces of wheels on rails, and their derivatives. On the rail, in N and N mm.",
        (
            "definitions.json#/definitions/wrench",
            "definitions.json#/definitions/wheel_rail_forces",
            "definitions.json#/definitions/wheel_rail_derivatives",
        ),
    ),
    Module(
        "wheel_rail/places",
        "Where a wheel touches its rail, as profiles and positions tell it. Lengths in mm, angles in rad.",
        (
            "definitions.json#/definitions/contact_reference",
            "definitions.json#/definitions/contact_place",
            "wheelrail.geometry.result.json#/properties/geometries/items",
        ),
    ),
    Module(
        "wheel_rail/rigid_wheelset",
        "A rigid wheelset on rigid rails: the answers of `Client.wheelset_contacts`, `Client.equivalent_conicity` and "
        "`Client.placed_profiles`. Lengths in mm, angles in rad.",
        (
            "wheelrail.geometry.params.json#/properties/contacts/properties/roll",
            "wheelrail.geometry.result.json#/properties/contacts/items",
            "wheelrail.geometry.result.json#/properties/conicities/items",
            "wheelrail.geometry.result.json#/properties/profiles",
        ),
    ),
    Module(
        "wheel_rail/result",
        "What is answered of a wheel on its rail, and of a wheelset. Lengths in mm, angles in rad, forces in N on the rail.",
        ("wheelrail.solve.result.json#", "wheelrail.wheelset.result.json#"),
    ),
]

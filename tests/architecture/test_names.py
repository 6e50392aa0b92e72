"""Names are the same on the wire, in C++ and in Python: what a schema has in an object, a struct of the public headers and
a class of the Python client have as their fields. docs/architecture.md says what differs on purpose."""

from __future__ import annotations

import ast
import json
import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
HEADERS = [*ROOT.glob("core/include/contactd/*.hpp"), *ROOT.glob("client/cpp/include/contactd/client/*.hpp")]
MODULES = [*ROOT.glob("client/python/contactd/**/*.py")]

#: Schema, place of the object in it, struct, class, or both that it may be; "" where it is spread over several, or a mapping.
SAME = [
    ("contact.solve.params", "gap/paraboloid", "Paraboloid", "Paraboloid"),
    ("contact.solve.params", "gap/semi_axes", "SemiAxes", "SemiAxes"),
    ("contact.solve.params", "friction", "", "Friction"),
    ("contact.solve.params", "friction/kinetic", "KineticFriction", "KineticFriction"),
    ("contact.solve.params", "friction/rigid_slip", "RigidSlip", ""),
    ("contact.solve.params", "friction/temperature", "TemperatureFriction", "TemperatureFriction"),
    ("contact.solve.params", "previous", "SurfaceState", "Estimate"),
    ("contact.solve.params", "initial", "SurfaceState", "Estimate"),
    ("contact.solve.params", "columns", "ContactColumns", "ContactColumns"),
    ("contact.solve.params", "settings", "ContactSettings", ""),
    ("contact.solve.params", "settings/normal", "SolverSettings", "SolverSettings"),
    ("contact.solve.result", "", "ContactSolution", "ContactSolution"),
    ("contact.solve.result", "forces", "Forces", "Forces"),
    ("contact.solve.result", "resultant", "Resultant", "Resultant"),
    ("contact.solve.result", "area", "Areas", "Areas"),
    ("contact.solve.result", "elements", "Counts", "Counts"),
    ("contact.solve.result", "motion", "Shift Rolling", "Shift Rolling"),
    ("contact.solve.result", "derivatives", "Derivatives", "Derivatives"),
    ("contact.solve.result", "evidence", "", "ContactEvidence"),
    ("contact.solve.result", "evidence/discretisation", "Discretisation", "Discretisation"),
    ("contact.solve.result", "evidence/operators", "OperatorUse", "OperatorUse"),
    ("contact.solve.result", "evidence/ics", "IcUses", ""),
    ("session.step.result", "", "", "StepSolution"),
    ("session.step.result", "evidence", "ContactEvidence", "ContactEvidence"),
    ("session.step.params", "wheelrail", "WheelRailStepInput", "WheelRailStepInput"),
    ("session.info.result", "", "SessionInfo", ""),
    ("session.list.result", "sessions", "SessionSummary", "SessionSummary"),
    ("contact.subsurface.params", "block", "StressBlock", "StressBlock"),
    ("contact.subsurface.result", "stress", "SubsurfaceStress", "SubsurfaceStress"),
    ("contact.subsurface.result", "largest", "LargestStress", "LargestStress"),
    ("contact.temperature.result", "", "SurfaceTemperatures", "SurfaceTemperatures"),
    ("definitions", "thermal_body", "ThermalBody", "ThermalBody"),
    ("definitions", "thermal_bodies", "ThermalBodies", "ThermalBodies"),
    ("definitions", "contact_temperature", "ContactTemperature", "ContactTemperature"),
    ("definitions", "wear_request", "WearRequest", "WearRequest"),
    ("definitions", "wear_law", "WearLaw", "WearLaw"),
    ("definitions", "contact_wear", "ContactWear", "ContactWear"),
    ("definitions", "contact_wear/rows", "WearRow", "WearRow"),
    ("definitions", "contact_wear/laws", "LawWear", "LawWear"),
    ("definitions", "fatigue_request", "FatigueRequest", "FatigueRequest"),
    ("definitions", "fatigue_strength", "FatigueStrength", "FatigueStrength"),
    ("definitions", "damage_function", "DamageFunction", "DamageFunction"),
    ("definitions", "passage", "Passage", "Passage"),
    ("definitions", "contact_fatigue", "ContactFatigue", "ContactFatigue"),
    ("definitions", "contact_fatigue/rows", "FatigueRow", "FatigueRow"),
    ("definitions", "contact_fatigue/damages", "FunctionDamage", "FunctionDamage"),
    ("definitions", "stress_place", "StressPlace", "StressPlace"),
    ("definitions", "rolling_resistance", "RollingResistance", "RollingResistance"),
    ("definitions", "body/viscoelastic", "Viscoelasticity", "ViscoelasticBody"),
    ("definitions", "wheel_rail_setup", "WheelRailSetup", ""),
    ("definitions", "wheel_rail_setup/wheelset", "Wheelset", "Wheelset"),
    ("definitions", "wheel_rail_setup/track", "Track", "Track"),
    ("definitions", "wheel_rail_friction", "WheelRailFriction", "WheelRailFriction"),
    ("definitions", "wheel_rail_setup/patches", "PatchRules", "PatchRules"),
    ("definitions", "wheel_rail_state", "WheelRailState", "WheelRailState"),
    ("definitions", "wheel_rail_state/position", "WheelsetPosition", "WheelsetPosition"),
    ("definitions", "wheel_rail_state/velocity", "WheelsetVelocity", "WheelsetVelocity"),
    ("definitions", "wheel_rail_state/rail", "RailDeviation", "RailDeviation"),
    ("definitions", "contact_reference", "ContactReference", "ContactReference"),
    ("definitions", "contact_place", "ContactPlace", "ContactPlace"),
    ("definitions", "contact_place/regions", "OverlapRegion", "OverlapRegion"),
    ("definitions", "contact_place/creepages", "Creepages", "Creepages"),
    ("definitions", "contact_place/radii", "ContactRadii", "ContactRadii"),
    ("definitions", "wrench", "Wrench", "Wrench"),
    ("definitions", "wheel_rail_forces", "WheelRailForces", "WheelRailForces"),
    ("definitions", "wheel_rail_setup/rail_slices", "RailSlice", ""),
    ("definitions", "wheel_rail_setup/wheel_slices", "WheelSlice", ""),
    ("definitions", "wheel_rail_setup/track/springs", "RailSprings", "RailSprings"),
    ("wheelrail.solve.result", "rail_deflection", "RailDeflection", "RailDeflection"),
    ("definitions", "wheel_rail_derivatives", "WheelRailDerivatives", "WheelRailDerivatives"),
    ("wheelrail.solve.result", "", "WheelRailSolution", "WheelRailSolution"),
    ("wheelrail.solve.result", "patches", "WheelRailPatch", "WheelRailPatch"),
    ("wheelrail.wheelset.params", "state", "WheelsetState", "WheelsetState"),
    ("wheelrail.wheelset.result", "", "WheelsetSolution", "WheelsetSolution"),
    ("wheelrail.geometry.result", "conicities", "EquivalentConicity", "EquivalentConicity"),
    ("wheelrail.geometry.result", "contacts", "WheelsetContacts", "WheelsetContacts"),
    ("wheelrail.geometry.result", "contacts/left", "RigidContact", "RigidContact"),
    ("wheelrail.geometry.result", "profiles", "ProfilesOfSides", "ProfilesOfSides"),
    ("wheelrail.geometry.result", "profiles/left", "PlacedProfiles", "PlacedProfiles"),
    ("wheelrail.geometry.result", "profiles/left/rail_origin", "ProfilePoint", "ProfileOrigin"),
    ("contact_file.read.result", "cases", "ContactCase", "ContactCase"),
    ("wheelrail.geometry.result", "geometries", "WheelRailGeometry", "WheelRailGeometry"),
    ("definitions", "profile/file", "ProfileFile", "ProfileFile"),
    ("definitions", "profile/file/kinks", "KinkRule", "KinkRule"),
    ("definitions", "profile_evidence", "ProfileEvidence", "ProfileEvidence"),
    ("definitions", "profile_evidence/wheel", "WheelLandmarks", "WheelLandmarks"),
    ("definitions", "profile_evidence/wheel/tip", "ProfilePoint", "ProfilePlace"),
    ("definitions", "profile_evidence/file", "ProfileReading", "ProfileReading"),
    ("definitions", "material", "Material", "Material"),
    ("definitions", "grid", "Grid", "Grid"),
    ("definitions", "rolling", "Rolling", "Rolling"),
    ("definitions", "ics/line_contact", "LineContactSpec", "LineContact"),
    ("definitions", "ics/layers", "Layer", "Layer"),
    ("definitions", "ic_evidence", "IcEvidence", "IcEvidence"),
    ("definitions", "ic_evidence/mesh", "FemSpec", "FemIcs"),
    ("definitions", "ic_evidence/seconds", "BuildSeconds", ""),
    ("definitions", "ic_evidence/load_cases", "LoadCaseEvidence", "LoadCase"),
    ("definitions", "ic_evidence/errors", "IcErrors", "IcErrors"),
    ("definitions", "ic_evidence/errors/xx", "ComponentError", "ComponentError"),
    ("definitions", "ic_use", "IcUse", "IcUse"),
    ("definitions", "derivatives_of_answer", "DerivativesOfAnswer", "DerivativesOfAnswer"),
    ("definitions", "solver_evidence", "SolverEvidence", "SolverEvidence"),
    ("definitions", "status/details", "Status", ""),
    ("definitions", "status/details/violations", "Violation", "Violation"),
    ("ic.list.result", "tables", "StoredIc", "StoredIc"),
    ("ic.list.result", "quarantined", "QuarantinedIc", "QuarantinedIc"),
    ("job.list.result", "jobs", "Job", "Job"),
    ("solves.recent.result", "solves", "RecentSolve", "RecentSolve"),
    ("solves.pressures.result", "patches", "RecentPatch", "RecentPatch"),
    ("progress", "progress", "Progress", "Progress"),
    ("server.info.result", "", "ServerInfo", "ServerInfo"),
    ("server.info.result", "limits", "ServerLimits", "Limits"),
    ("server.info.result", "counters", "ServerCounters", ""),
    ("server.info.result", "cache", "CacheUse", ""),
    ("server.info.result", "queue", "QueueLengths", ""),
    ("server.metrics.result", "metrics", "Metric", ""),
    ("server.metrics.result", "metrics/samples", "MetricSample", ""),
    ("server.metrics.result", "metrics/samples/buckets", "MetricBucket", ""),
]


#: Names that are keywords of C++, or that its reference is not made with.
KEYWORDS = {"module": "module_number"}


def names_on_the_wire(schema: str, place: str) -> set[str]:
    told: dict[str, Any] = json.loads((ROOT / "proto" / "schema" / f"{schema}.json").read_text())
    if schema == "definitions":
        told = {"properties": told["definitions"]}
    for name in filter(None, place.split("/")):
        told = told["properties"][name]
        told = told.get("items", told)
    return set(told["properties"])


def structs() -> dict[str, tuple[list[str], str]]:
    """Bases and body of each struct, without comments, and without what is in parentheses, brackets and inner braces."""
    found = {}
    for header in HEADERS:
        text = re.sub(r"//.*", "", header.read_text())
        for start in re.finditer(r"\bstruct (\w+)(?: : ([\w, ]+))? \{\n", text):
            body = text[start.end() : text.index("\n}", start.end())]
            while (outer := re.sub(r"\([^()]*\)|\{[^{}]*\}|<[^<>]*>", " ", body)) != body:
                body = outer
            found[start[1]] = (re.findall(r"\w+", start[2] or ""), body)
    return found


def classes() -> dict[str, tuple[list[str], list[str]]]:
    """Bases, and names of fields and functions, of each class."""
    found = {}
    for module in MODULES:
        for kind in ast.parse(module.read_text()).body:
            if isinstance(kind, ast.ClassDef):
                names = [part.target.id for part in kind.body if isinstance(part, ast.AnnAssign)]  # type: ignore[union-attr]
                names += [part.name for part in kind.body if isinstance(part, ast.FunctionDef)]
                bases = [name.id for base in kind.bases for name in ast.walk(base) if isinstance(name, ast.Name)]
                found[kind.name] = (bases, names)
    return found


STRUCTS, CLASSES = structs(), classes()


def fields_of_struct(name: str) -> set[str]:
    bases, body = STRUCTS[name]
    own = {names[-1] for part in re.split(r"[;,]", re.sub(r"=[^;,]*", "", body)) if (names := re.findall(r"\w+", part))}
    own |= set(re.findall(r"(\w+)\s+const\b", body))  # functions
    return own.union(*(fields_of_struct(base) for base in bases))


def fields_of_class(name: str) -> set[str]:
    bases, own = CLASSES[name]
    return set(own).union(*(fields_of_class(base) for base in bases if base in CLASSES))


@pytest.mark.parametrize(("schema", "place", "struct", "kind"), SAME)
def test_a_field_has_one_name(schema: str, place: str, struct: str, kind: str) -> None:
    wire = names_on_the_wire(schema, place) - {"wheelrail"}  # the result of wheelrail.solve, which has a line of its own
    if struct:
        assert {KEYWORDS.get(name, name) for name in wire} <= set().union(*map(fields_of_struct, struct.split()))
    if kind:
        assert wire <= set().union(*map(fields_of_class, kind.split()))


def test_the_headers_are_understood() -> None:
    assert fields_of_struct("Areas") == {"contact", "adhesion", "slip", "flow"}
    assert {"approach", "forces", "evidence", "slip_y", "converged"} <= fields_of_struct("ContactSolution")
    assert "max_frames" in fields_of_struct("ServerLimits")  # of its base

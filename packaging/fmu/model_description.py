"""Writes the modelDescription.xml of an FMU, in FMI 2.0 and 3.0, from the output of contactd-fmu-description."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from typing import Any

__all__ = ["model_description"]

Json = Mapping[str, Any]
#: Role -> causality and variability of a real, and of all other types.
ROLES = {
    "time": ("independent", "continuous", "continuous"),
    "parameter": ("parameter", "fixed", "fixed"),
    "tunable": ("parameter", "tunable", "tunable"),
    "input": ("input", "continuous", "discrete"),
    "output": ("output", "continuous", "discrete"),
}
CATEGORIES = {"errors": "Failures, always reported.", "warnings": "Of steps.", "events": "How far a build is."}
CAN = {
    "canHandleVariableCommunicationStepSize": "true",
    "canBeInstantiatedOnlyOncePerProcess": "false",
    "needsExecutionTool": "false",
}
#: Type -> element in FMI 2 and in FMI 3.
TYPES = {
    "real": ("Real", "Float64"), "integer": ("Integer", "Int32"), "boolean": ("Boolean", "Boolean"),
    "enumeration": ("Enumeration", "Enumeration"), "text": ("String", "String"),
}  # fmt: skip


def model_description(kind: Json, units: list[Json], version: str, fmi: int) -> bytes:
    """Returns the description. `kind` and `units` are parts of that JSON, `version` is contactd's, and `fmi` is 2 or 3."""
    of = {2: _Fmi2, 3: _Fmi3}[fmi](kind, units, version)
    ET.indent(of.root)
    return ET.tostring(of.root, encoding="UTF-8", xml_declaration=True)


class _Description:
    """Returns the attributes that both versions share. A value reference is a variable's position in the list."""

    def __init__(self, kind: Json, units: list[Json], version: str, root: Mapping[str, str]) -> None:
        self.kind = kind
        self.variables: list[Json] = kind["variables"]
        common = {"modelName": kind["name"], "description": kind["says"], "version": version}
        made = {"generationTool": f"contactd {version}", "variableNamingConvention": "structured"}
        self.root = ET.Element("fmiModelDescription", {**root, **common, **made})
        self.co_simulation()
        self.units(units)
        self.types()
        categories = ET.SubElement(self.root, "LogCategories")
        for name, says in CATEGORIES.items():
            ET.SubElement(categories, "Category", name=name, description=says)
        ET.SubElement(self.root, "DefaultExperiment", startTime="0", stopTime="1", stepSize="0.001")
        self.model_variables(ET.SubElement(self.root, "ModelVariables"))
        self.structure(ET.SubElement(self.root, "ModelStructure"))

    def co_simulation(self) -> None:
        raise NotImplementedError

    def types(self) -> None:
        raise NotImplementedError

    def model_variables(self, parent: ET.Element) -> None:
        raise NotImplementedError

    def structure(self, parent: ET.Element) -> None:
        raise NotImplementedError

    def units(self, units: list[Json]) -> None:
        used = {variable["unit"] for variable in self.variables}
        definitions = ET.SubElement(self.root, "UnitDefinitions")
        for unit in units:
            if unit["name"] not in used:
                continue
            exponents = {base: str(unit[base]) for base in ("kg", "m", "s", "K", "rad") if unit[base]}
            factor = {} if unit["factor"] == 1 else {"factor": repr(float(unit["factor"]))}
            offset = {"offset": repr(float(unit["offset"]))} if unit["offset"] else {}
            base = {**exponents, **factor, **offset}
            ET.SubElement(ET.SubElement(definitions, "Unit", name=unit["name"]), "BaseUnit", base)

    def enumerations(self) -> Iterator[Json]:
        """Returns each unit once."""
        seen: dict[str, Json] = {}
        for variable in self.variables:
            if "enumeration" in variable:
                seen.setdefault(variable["enumeration"]["name"], variable["enumeration"])
        return iter(seen.values())

    def attributes(self, reference: int) -> dict[str, str]:
        variable = self.variables[reference]
        causality, of_reals, of_others = ROLES[variable["role"]]
        variability = of_reals if variable["type"] == "real" else of_others
        all_ = {
            "name": variable["name"], "valueReference": str(reference), "causality": causality,
            "variability": variability, "description": variable["says"],
        }  # fmt: skip
        initial = {"output": "calculated", "parameter": "exact", "tunable": "exact"}.get(variable["role"])
        return all_ | ({"initial": initial} if initial else {})

    def typed(self, variable: Json) -> dict[str, str]:
        """Returns unit, declared type and start value, as far as the variable has them."""
        found = {}
        if variable["type"] == "enumeration":
            found["declaredType"] = variable["enumeration"]["name"]
        if variable["type"] == "real" and variable["unit"]:
            found["unit"] = variable["unit"]
        if variable["role"] not in ("time", "output"):
            start = variable["start"]
            found["start"] = str(start).lower() if isinstance(start, bool) else str(start)
        return found

    def outputs(self) -> list[int]:
        return [reference for reference, variable in enumerate(self.variables) if variable["role"] == "output"]


class _Fmi2(_Description):
    def __init__(self, kind: Json, units: list[Json], version: str) -> None:
        super().__init__(kind, units, version, {"fmiVersion": "2.0", "guid": kind["token"]})

    def co_simulation(self) -> None:
        ET.SubElement(self.root, "CoSimulation", {
            "modelIdentifier": self.kind["name"], **CAN, "canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true",
            "providesDirectionalDerivative": "true",
        })  # fmt: skip

    def types(self) -> None:
        definitions = ET.SubElement(self.root, "TypeDefinitions")
        for enumeration in self.enumerations():
            simple = ET.SubElement(definitions, "SimpleType", name=enumeration["name"])
            of = ET.SubElement(simple, "Enumeration")
            for value, word in enumerate(enumeration["words"]):
                ET.SubElement(of, "Item", name=word, value=str(value))

    def model_variables(self, parent: ET.Element) -> None:
        for reference, variable in enumerate(self.variables):
            if variable["role"] == "time":
                continue  # FMI 2 predefines them
            scalar = ET.SubElement(parent, "ScalarVariable", self.attributes(reference))
            ET.SubElement(scalar, TYPES[variable["type"]][0], self.typed(variable))

    def structure(self, parent: ET.Element) -> None:
        for name in ("Outputs", "InitialUnknowns"):
            unknowns = ET.SubElement(parent, name)
            for reference in self.outputs():
                ET.SubElement(unknowns, "Unknown", index=str(reference))  # counted from 1, without time


class _Fmi3(_Description):
    def __init__(self, kind: Json, units: list[Json], version: str) -> None:
        super().__init__(kind, units, version, {"fmiVersion": "3.0", "instantiationToken": kind["token"]})

    def co_simulation(self) -> None:
        ET.SubElement(self.root, "CoSimulation", {
            "modelIdentifier": self.kind["name"], **CAN, "canGetAndSetFMUState": "true", "canSerializeFMUState": "true",
            "providesDirectionalDerivatives": "true", "hasEventMode": "false",
        })  # fmt: skip

    def types(self) -> None:
        definitions = ET.SubElement(self.root, "TypeDefinitions")
        for enumeration in self.enumerations():
            of = ET.SubElement(definitions, "EnumerationType", name=enumeration["name"])
            for value, word in enumerate(enumeration["words"]):
                ET.SubElement(of, "Item", name=word, value=str(value))

    def model_variables(self, parent: ET.Element) -> None:
        for reference, variable in enumerate(self.variables):
            typed = self.typed(variable)
            start = typed.pop("start", None) if variable["type"] == "text" else None
            element = ET.SubElement(parent, TYPES[variable["type"]][1], {**self.attributes(reference), **typed})
            if start is not None:
                ET.SubElement(element, "Start", value=start)

    def structure(self, parent: ET.Element) -> None:
        for name in ("Output", "InitialUnknown"):
            for reference in self.outputs():
                ET.SubElement(parent, name, valueReference=str(reference))

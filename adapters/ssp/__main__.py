"""Makes an SSP archive of a wheelset from four FMUs for co-simulation: its body, the track, and its two wheels on
their rails.

    python3 adapters/ssp WHEEL_FMU HEADERS OUTPUT

WHEEL_FMU is contactd_wheel_fmi2.fmu, and HEADERS is the folder of fmi2Functions.h. A C compiler (CC, default cc) makes
the two small FMUs. docs/plugged-in.md describes how to run the archive.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.append(str(FOLDER.parents[1] / "packaging" / "fmu"))

from archive import write_fmu  # noqa: E402  of packaging/fmu

NAMESPACES = {
    "ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
    "ssc": "http://ssp-standard.org/SSP1/SystemStructureCommon",
    "ssv": "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
}
for _prefix, _address in NAMESPACES.items():
    ET.register_namespace(_prefix, _address)

#: Name, causality and start value of the variables of the small FMUs, in the order of their value references. Units:
#: kg, kg m^2, N/mm, N s/mm, N mm/rad, N mm s/rad, N, N mm, mm, rad, and the rates per second.
PARTS = {
    "body": (
        ("mass", "parameter", 1000.0), ("inertia", "parameter", 600.0), ("k_y", "parameter", 0.0), ("c_y", "parameter", 0.0),
        ("k_yaw", "parameter", 0.0), ("c_yaw", "parameter", 0.0), ("Fy_left", "input", 0.0), ("Fy_right", "input", 0.0),
        ("Mz_left", "input", 0.0), ("Mz_right", "input", 0.0), ("y_start", "parameter", 3.0), ("y", "output", None),
        ("yaw", "output", None), ("y_rate", "output", None), ("yaw_rate", "output", None),
    ),
    "track": (
        ("velocity", "parameter", 10e3), ("height", "parameter", 0.0), ("length", "parameter", 5e3),
        ("begins", "parameter", 0.0), ("y", "output", None), ("y_rate", "output", None),
    ),
}  # fmt: skip

VELOCITY = 10e3  #: mm/s
RADIUS = 460.0  #: mm, that of contactd_wheel
_WHEEL: dict[str, float | int] = {
    "model_number": 2, "coordinates_number": 2, "elements.dx": 1.0, "elements.dy": 1.0, "load.Fz": 50e3,
    "velocity.x": VELOCITY, "velocity.pitch": -VELOCITY / RADIUS,
}  # fmt: skip


@dataclass
class Component:
    """Describes an FMU of the system, its connected variables, and its parameters."""

    source: str
    inputs: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    parameters: dict[str, float | int] = field(default_factory=dict)


_MOVES = ("position.y", "position.yaw", "velocity.y", "velocity.yaw", "deviation.y", "deviation_rate.y")
COMPONENTS = {
    "body": Component("body.fmu", ("Fy_left", "Fy_right", "Mz_left", "Mz_right"), ("y", "yaw", "y_rate", "yaw_rate")),
    "track": Component("track.fmu", (), ("y", "y_rate"), {"velocity": VELOCITY}),
    "left": Component("contactd_wheel.fmu", _MOVES, ("Fy", "Mz", "pmax"), {**_WHEEL, "side_number": 0}),
    "right": Component("contactd_wheel.fmu", _MOVES, ("Fy", "Mz", "pmax"), {**_WHEEL, "side_number": 1}),
}
CONNECTIONS = [
    *((("body", start), (side, end)) for side in ("left", "right") for start, end in zip(("y", "yaw", "y_rate", "yaw_rate"), _MOVES, strict=False)),
    *((("track", start), (side, end)) for side in ("left", "right") for start, end in (("y", "deviation.y"), ("y_rate", "deviation_rate.y"))),
    *(((side, force), ("body", f"{force}_{side}")) for side in ("left", "right") for force in ("Fy", "Mz")),
]  # fmt: skip


def part_description(name: str) -> bytes:
    """Returns the modelDescription.xml of a small FMU."""
    variables = PARTS[name]
    root = ET.Element("fmiModelDescription", {
        "fmiVersion": "2.0", "modelName": name, "guid": f"{{{hashlib.sha256(repr((name, variables)).encode()).hexdigest()[:32]}}}",
        "description": "Part of the wheelset of contactd's SSP archive.", "variableNamingConvention": "structured",
    })  # fmt: skip
    ET.SubElement(root, "CoSimulation", modelIdentifier=name, canHandleVariableCommunicationStepSize="true", canGetAndSetFMUstate="true")
    listed = ET.SubElement(root, "ModelVariables")
    for reference, (variable, causality, start) in enumerate(variables):
        initial = {"initial": "calculated"} if start is None else {}
        variability = "fixed" if causality == "parameter" else "continuous"
        scalar = ET.SubElement(
            listed, "ScalarVariable", name=variable, valueReference=str(reference), causality=causality, variability=variability, **initial
        )
        ET.SubElement(scalar, "Real", {} if start is None else {"start": str(start)})
    structure = ET.SubElement(root, "ModelStructure")
    unknown = [str(index) for index, (_, causality, _) in enumerate(variables, 1) if causality == "output"]
    for element in ("Outputs", "InitialUnknowns"):
        of = ET.SubElement(structure, element)
        for index in unknown:
            ET.SubElement(of, "Unknown", index=index)
    ET.indent(root)
    return ET.tostring(root, encoding="UTF-8", xml_declaration=True)


def part_header(name: str) -> str:
    """Returns the definitions of the variables that its source includes."""
    starts = ", ".join(repr(0.0 if start is None else start) for _, _, start in PARTS[name])
    return f"enum {{ {', '.join(variable.upper() for variable, _, _ in PARTS[name])} }};\n#define PART_STARTS {starts}\n"


def write_part(name: str, headers: Path, folder: Path) -> Path:
    """Compiles a small FMU for this machine, 64-bit Linux, into `folder`."""
    library = folder / f"{name}.so"
    (folder / "part_variables.h").write_text(part_header(name))
    command = [os.environ.get("CC", "cc"), "-std=c99", "-O2", "-fPIC", "-shared", "-Wall", "-Wextra", "-Werror", "-I", str(headers), "-I", str(folder)]
    subprocess.run([*command, str(FOLDER / "fmi2.c"), str(FOLDER / f"{name}.c"), "-o", str(library), "-lm"], check=True)
    files = {"modelDescription.xml": part_description(name), f"binaries/linux64/{name}.so": library.read_bytes()}
    return write_fmu(folder / f"{name}.fmu", files)


def _named(prefix: str, name: str) -> str:
    return f"{{{NAMESPACES[prefix]}}}{name}"


def _connectors(component: Component) -> Iterator[tuple[str, str]]:
    yield from ((name, "input") for name in component.inputs)
    yield from ((name, "output") for name in component.outputs)


def system_structure() -> bytes:
    """Returns SystemStructure.ssd of the wheelset, SSP 1.0."""
    root = ET.Element(_named("ssd", "SystemStructureDescription"), version="1.0", name="wheelset")
    system = ET.SubElement(root, _named("ssd", "System"), name="wheelset")
    elements = ET.SubElement(system, _named("ssd", "Elements"))
    for name, component in COMPONENTS.items():
        of = ET.SubElement(
            elements, _named("ssd", "Component"), name=name, type="application/x-fmu-sharedlibrary", source=f"resources/{component.source}"
        )
        connectors = ET.SubElement(of, _named("ssd", "Connectors"))
        for connector, kind in _connectors(component):
            ET.SubElement(ET.SubElement(connectors, _named("ssd", "Connector"), name=connector, kind=kind), _named("ssc", "Real"))
        if component.parameters:
            bindings = ET.SubElement(of, _named("ssd", "ParameterBindings"))
            ET.SubElement(bindings, _named("ssd", "ParameterBinding"), source=f"resources/{name}.ssv")
    connections = ET.SubElement(system, _named("ssd", "Connections"))
    for (start, output), (end, given) in CONNECTIONS:
        ET.SubElement(
            connections, _named("ssd", "Connection"), startElement=start, startConnector=output, endElement=end, endConnector=given
        )
    ET.SubElement(root, _named("ssd", "DefaultExperiment"), startTime="0", stopTime="1")
    ET.indent(root)
    return ET.tostring(root, encoding="UTF-8", xml_declaration=True)


def parameter_values(name: str, component: Component) -> bytes:
    """Returns the parameters of a component, resources/NAME.ssv. The component refers to them, because all masters look
    for them there."""
    root = ET.Element(_named("ssv", "ParameterSet"), version="1.0", name=name)
    listed = ET.SubElement(root, _named("ssv", "Parameters"))
    for parameter, value in component.parameters.items():
        of = ET.SubElement(listed, _named("ssv", "Parameter"), name=parameter)
        ET.SubElement(of, _named("ssv", "Integer" if isinstance(value, int) else "Real"), value=str(value))
    ET.indent(root)
    return ET.tostring(root, encoding="UTF-8", xml_declaration=True)


def write_ssp(wheel: Path, headers: Path, output: Path) -> Path:
    with tempfile.TemporaryDirectory() as folder:
        parts = {f"resources/{name}.fmu": write_part(name, headers, Path(folder)).read_bytes() for name in PARTS}
    values = {f"resources/{name}.ssv": parameter_values(name, of) for name, of in COMPONENTS.items() if of.parameters}
    files = {"SystemStructure.ssd": system_structure(), **values, **parts}
    return write_fmu(output, {**files, "resources/contactd_wheel.fmu": wheel.read_bytes()})


def main() -> None:
    parser = argparse.ArgumentParser(prog="adapters/ssp", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("wheel", "headers", "output"):
        parser.add_argument(name, type=Path)
    options = parser.parse_args()
    print(write_ssp(options.wheel, options.headers, options.output))


if __name__ == "__main__":
    main()

"""Writes what a fuzzer starts from: a dictionary of all words of the schemas, and good messages of every kind.

    seeds.py FOLDER    writes FOLDER/json.dict and FOLDER/<target>/*
"""

from __future__ import annotations

import json
import math
import re
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import h5py
import numpy as np

ROOT = Path(__file__).parents[2]
METHODS = sorted(path.name.removesuffix(".params.json") for path in (ROOT / "proto/schema").glob("*.params.json"))


def words_of(schema: Any) -> Iterator[str]:
    """Yields names of fields and values of enumerations, anywhere in a schema."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {}) if isinstance(schema.get("properties"), dict) else ()
        yield from (value for value in schema.get("enum", []) if isinstance(value, str))
        for child in schema.values():
            yield from words_of(child)
    elif isinstance(schema, list):
        for child in schema:
            yield from words_of(child)


def dictionary() -> str:
    files = [*(ROOT / "proto/schema").glob("*.json"), ROOT / "configs/schema.json"]
    words = {word for path in files for word in words_of(json.loads(path.read_text()))}
    words |= {"$array", "<f8", "|u1", *METHODS}
    tokens = [f'\\"{word}\\"' for word in sorted(words)]
    tokens += ["{", "}", "[", "]", ":", ",", "null", "true", "false", "1e308", "1e-308", "1e999", "9223372036854775807"]
    tokens += ["18446744073709551616", "-0", "NaN", r"\\u0000", r"\\ud800", r"\xef\xbb\xbf", r"\x00"]
    return "".join(f'"{token}"\n' for token in tokens)


def message(envelope: Any, *frames: bytes) -> bytes:
    """Encodes a message as tests/fuzz/input.hpp reads it."""
    return json.dumps(envelope).encode() + b"\0" + b"".join(struct.pack("<H", len(f)) + f for f in frames)


def documented(method: str) -> Any:
    """Returns the request that docs/protocol.md shows for the method, or no parameters."""
    text = (ROOT / "docs/protocol.md").read_text()
    section = text.partition(f"### `{method}`")[2].partition("\n### ")[0]
    block = re.search(r"(?:^ {4}.*\n)+", section, re.MULTILINE)
    return json.loads(block.group()) if block and block.group().lstrip().startswith("{") else {}


def array(frame: int, *shape: int) -> Any:
    return {"$array": {"frame": frame, "dtype": "<f8", "shape": list(shape)}}


def solves() -> Iterator[tuple[dict[str, Any], list[bytes]]]:
    """Returns parameters of contact.solve that use every field, with their frames."""
    base = {"grid": {"nx": 3, "ny": 2, "dx": 0.06, "dy": 0.06, "x0": -1, "y0": 0}}
    bodies = {"upper": {"G": 200, "nu": 0.42}, "lower": {"rigid": True}}
    ones = np.ones((2, 3)).tobytes()
    rolling = {"xi": 1e-3, "eta": 0, "phi": 1e-4, "chi": 0.1, "dq": 0.05, "spin_offset": 0.25, "velocity": 3}
    yield {
        **base, "bodies": bodies, "ics": {"source": "analytic", "body": "half_space"}, "gap": {"array": array(1, 2, 3)}, "Fn": 2,
        "friction": {"mu": array(2, 2, 3), "kinetic": {"law": "linear", "mu": 0.1, "slip_velocity": 3},
                     "rolling": {**rolling, "kind": "transient", "steps": 3, "force": [None, 1.5]}},
        "previous": {"pressure": array(1, 2, 3), "traction_x": array(2, 2, 3), "traction_y": array(1, 2, 3)},
    }, [ones, ones]
    layers = [{"thickness": 2, "G": 1, "nu": 0.5}, {"thickness": 0.1, "G": 30, "nu": 0.2}]
    layered = {"source": "analytic", "body": "layered", "layers": layers, "base": {"rigid": True}}
    yield {
        **base, "bodies": {"upper": {"ics": {**layered, "base": {"G": 5, "nu": 0.3}}}, "lower": {"ics": layered}},
        "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2,
    }, []
    steady = {**rolling, "chi": 0, "kind": "steady"}
    steel = {"bulk_temperature": 20, "conductivity": 50, "heat_capacity": 450, "density": 7850}
    yield {
        **base, "bodies": bodies, "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2,
        "temperature": {"upper": steel, "lower": {"bulk_temperature": 90}, "plastic_share": 0.9},
        "friction": {"mu": 0.3, "temperature": {"change": -0.1, "reference": 20, "range": 300, "memory": {"distance": 1e-3, "least_velocity": 1}}, "rolling": steady},
    }, []
    pieces = [{"from": 0, "value": 1, "slope": 5}, {"from": 10, "value": 55, "slope": 0}]
    law = {"source": "a test", "body": "lower", "range": [0, 10], "zones": [{"angle": -1, "factor": 0.1}, {"angle": 0, "factor": 1}]}
    archard = {"hardness": 3000, "mild": 1e-4, "severe": {"k": 1e-3, "velocity": [1, 2]}, "seizure": {"k": 1e-2, "pressure": 0.8}}
    yield {
        **base, "bodies": bodies, "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2,
        "wear": {"energy": "plain", "laws": [
            {"name": "a", "archard": archard, **law}, {"name": "b", "energy": {"coefficient": 1e-3}, **law},
            {"name": "c", "usfd": {"pieces": pieces, "density": 7850}, **law}, {"name": "d", "br": {"pieces": pieces}, **law},
            {"name": "e", "zobory": {"pieces": pieces, "density": 7850}, **law},
        ]},
        "friction": {"mu": 0.3, "rolling": {**steady, "velocity": 100}},
    }, []
    yield {
        **base, "bodies": bodies, "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2,
        "fatigue": {
            "body": "lower", "strength": {"name": "a", "source": "a test", "shear_yield": 300, "a_DV": 0.3, "tau_e": 200},
            "damages": [{"name": "a", "source": "a test", "range": [0, 10], "pieces": pieces}],
            "passage": {"depths": [0, 0.5], "residual": [{"depth": 0, "xx": -100, "yy": -50}]},
        },
        "friction": {"mu": 0.3, "rolling": {**steady, "velocity": 100}},
    }, []
    yield {
        **base, "bodies": bodies, "ics": {"source": "analytic"}, "gap": {"semi_axes": {"a": 1, "b": 2}}, "Fn": 2, "accuracy": 0.05,
        "friction": {"mu": 0.3, "rolling": steady},
    }, []
    regions = {"limits": [{"x": [-1, -0.9], "y": [0, 1]}, {"x": [-0.9, 0], "y": [0, 1]}], "shares": [1, 0.4, 0.4, 1]}
    yield {**base, "bodies": bodies, "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2, "regions": regions}, []
    creep = {"upper": {"G": 200, "nu": 0.42, "viscoelastic": {"f": 1, "tau": 0.01}}, "lower": {"rigid": True}}
    yield {
        **base, "bodies": creep, "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 10}}, "Fn": 2,
        "friction": {"mu": 0.3, "rolling": steady},
    }, []
    table = np.zeros((3, 3, 2, 3))
    table[range(3), range(3), 0, 0] = 1
    yield {
        **base, "ics": {"source": "table", "table": array(1, 3, 3, 2, 3), "dx": 0.06, "dy": 0.06},
        "gap": {"semi_axes": {"a": 1, "b": 2}}, "approach": 0.01,
        "friction": {"mu": 0.3, "rigid_shift": [1e-3, 0], "rotation": 0.1, "duration": 2, "force": [1, None]},
        "settings": {name: {"tolerance": 1e-6, "max_iterations": 10} for name in ("normal", "tangential", "outer")},
        "initial": {"pressure": [[0, 1, 0], [0, 1, 0]]}, "derivatives": True,
    }, [table.tobytes()]
    simplified = {"slope": {"k0": 0.6, "alpha": 0.1, "beta": 0.8}, "bound": "elliptic", "on_elements": True, "blended": True,
                  "coefficients": "printed", "k_adhesion": 0.8, "k_slip": 0.4}
    for model in ("fastsim", "fastrip", "polach"):
        yield {**base, "bodies": bodies, "model": model, "normal_model": "kpec", "simplified": simplified,
               "gap": {"array": array(1, 2, 3)}, "approach": 1, "friction": {"mu": 0.3, "rolling": rolling}}, [ones]
    for model in ("hertz", "fastsim"):
        yield {**base, "bodies": bodies, "model": model, "gap": {"paraboloid": {"Rx": 5, "Ry": 50}}, "Fn": 1,
               "friction": {"mu": 0.3, "rolling": rolling}}, []
    ics = {"source": "fem", "mesh": "hex", "order": 2, "l_over_h": 1, "h_over_hs": 4, "f": 1.2, "L_over_h": 640, "t1_over_hs": 1,
           "far_boundary": "clamped", "sampling": "linear", "solver": "amg_pcg", "stopping_criterion": "update", "tolerance": 1e-8,
           "max_iterations": 100, "strength_threshold": 0.5, "load_shape": "bilinear"}
    yield {**base, "bodies": {"upper": {"G": 1, "nu": 0.3}}, "ics": ics, "gap": {"paraboloid": {"Rx": 5}}, "approach": 0}, []


def requests() -> Iterator[bytes]:
    def request(method: str, params: Any, *frames: bytes, **more: Any) -> bytes:
        return message({"contactd": 1, "id": "7f", "method": method, "params": params, **more}, *frames)

    for method in METHODS:
        params = {"job": "build-3"} if method == "job.cancel" else documented(method)
        yield request(method, params, timeout_ms=2000, arrays="list", metadata={"a": 1, "client": "seeds 1"})
    for params, frames in solves():
        yield request("contact.solve", params, *frames)
        yield request("contact.solve_many", {"problems": [params, params]}, *frames)
    field = {"grid": {"nx": 3, "ny": 2, "dx": 1, "dy": 1}, "nu": 0.3, "pressure": array(1, 2, 3)}
    heat = {name: array(1, 2, 3) for name in ("pressure", "traction_x", "traction_y", "slip_x", "slip_y")}
    yield request("contact.temperature", {"grid": field["grid"], "velocity": 2e4, "upper_speed": 1.9e4, "chi": 0, "temperature": {"lower": {"density": 7e3}}, **heat}, bytes(48))
    yield request("contact.subsurface", {**field, "points": array(2, 2, 3)}, bytes(48), np.full(6, -1.0).tobytes())


def sessions() -> Iterator[bytes]:
    """Returns openings of sessions, with the parameters of contact.solve without those that steps must state, and
    steps of every kind."""
    for params, frames in solves():
        opening = {name: value for name, value in params.items() if name != "initial"}
        yield message({"contactd": 1, "id": "7f", "method": "session.open", "params": {**opening, "lease_seconds": 60}}, *frames)
        for name in ("gap", "approach", "Fn"):
            opening.pop(name, None)
        opening["accept_unconverged"] = True
        yield message({"contactd": 1, "id": "7f", "method": "session.open", "params": opening}, *frames)
    rolling = {"kind": "steady", "xi": 1e-3, "eta": 0, "phi": 1e-4, "chi": 0.1, "dq": 0.05, "spin_offset": 0.25, "velocity": 3, "steps": 2, "force": [None, 1]}
    kinetic = {"law": "exponential", "mu": 0.1, "slip_velocity": 3}
    shift = {"rigid_shift": [1e-3, 0], "rotation": 0.1, "duration": 2, "force": [None, None]}
    for friction in ({"rolling": rolling}, {"mu": array(1, 2, 3), "kinetic": kinetic, **shift}, {"mu": 0.2}):
        step = {"session": "0" * 32, "step": 1, "Fn": 1, "gap": {"array": array(1, 2, 3)}, "friction": friction, "derivatives": True, "fields": ["pressure", "slip_x"]}
        yield message({"contactd": 1, "id": "7f", "method": "session.step", "params": step}, np.full(6, 0.1).tobytes())
    step = {"session": "0" * 32, "step": 2, "approach": 0.1, "gap": {"semi_axes": {"a": 1, "b": 2}}}
    yield message({"contactd": 1, "id": "7f", "method": "session.step", "params": step})
    setup = {"side": "left", "rail": {"points": array(1, 3, 2)}, "friction": {"mu": [{"angle": -1, "mu": 0.1}, {"angle": 0, "mu": 0.3}]}, "dx": 1}
    options = {"unit": 25.4, "mirror_y": True, "mirror_z": False, "shift_y": 1, "shift_z": -1, "smoothing_length": 3, "smoothing_order": 3}
    file = {"name": "a.csv", "text": "y;z\n-2;0,2\n0;0\n2;0,2\n", "kinks": {"angle": 1, "rest": 0.1, "width": 1}, **options}
    setup |= {"wheel_slices": [{"angle": a, "profile": p} for a, p in ((-0.1, {"s1002": True}), (0.1, {"standard": {"name": "S1002"}}))], "wheel": {"file": file}, "track": {"springs": {"y": 1e4, "z": 1e5}}}
    opening = {"wheelrail": {"setup": setup}, "lease_seconds": 60, "accept_unconverged": True}
    yield message({"contactd": 1, "id": "7f", "method": "session.open", "params": opening}, np.array([[-20.0, 2], [0, 0], [20, 2]]).tobytes())
    state = {"position": {"y": 1, "yaw": 1e-3}, "velocity": {"x": 2000, "pitch": -4.3}, "rail": {"y": 0.1, "Fy": 10}, "Fz": 1e4, "derivatives": True}
    step = {"session": "0" * 32, "step": 1, "again": True, "wheelrail": {"state": state, "friction": {"mu": 0.2, "kinetic": kinetic}, "gap": True}, "fields": ["pressure"]}
    yield message({"contactd": 1, "id": "7f", "method": "session.step", "params": step})


def replies() -> Iterator[bytes]:
    def reply(result: Any, *frames: bytes) -> bytes:
        status = {"code": 0, "name": "OK", "message": ""}
        return message({"contactd": 1, "id": "7f", "status": status, "result": result}, *frames)

    yield message({"contactd": 1, "id": "7f", "progress": {"job": "build-3", "stage": "pcg", "fraction": 0.4, "iteration": 7, "residual": 1e-4}})
    yield message({"contactd": 1, "id": None, "status": {
        "code": 3, "name": "INVALID_ARGUMENT", "message": "x",
        "details": {"reason": "FIELD_INVALID", "violations": [{"field": "a", "description": "b"}], "retry_delay_ms": 5}}})
    load_case = {"load": "z", "iterations": 13, "residual": 3e-9, "converged": True, "seconds": 0.5, "update": 1e-9}
    evidence = {
        "source": "fem", "version": "1", "warnings": ["w"], "errors": {"zz": {"origin": -1e-3, "largest": 1e-2}, "scaled_xz": 1e-4},
        "errors_estimated": False, "elements": 1, "dofs": 81, "processes": 1, "solver": "direct", "load_cases": [load_case],
        "seconds": {"assembly": 0, "setup": 0, "solve": 0, "total": 0}, "family_nu": [0, 0.49], "interpolation_error": 1e-5,
    }
    use = {"origin": "closed_form", "key": "0" * 64, "evidence": evidence}
    statistics = {"iterations": 1, "residual": 1e-9, "converged": True, "seconds": 0.1}
    row = {"xi": 1, "eta": 2, "phi": 3, "rigid_shift": [4, 5], "rotation": 6, "approach": 7, "Fn": 8, "mu": 9}
    solution = {
        "derivatives": dict.fromkeys(("Fx", "Fy", "Mz", "Fn", "approach"), row),
        "approach": 0.1, "forces": {"Fn": 1, "Fx": 0, "Fy": 0, "Mz": 0}, "pmax": 1,
        "area": {"contact": 1, "adhesion": 0, "slip": 1}, "elements": {"contact": 1, "adhesion": 0, "slip": 1, "border": 0},
        "element_division": {"$array": {"frame": 1, "dtype": "|u1", "shape": [1, 1]}}, "warnings": [], "converged": True,
        **{name: array(2, 1, 1) for name in ("pressure", "traction_x", "traction_y", "pressure_by_approach")},
        "evidence": {
            "normal": statistics, "derivatives": statistics, "ics": {"upper": use, "lower": use},
            "operators": {"made": True, "bytes": 2, "budget_bytes": 1},
            "discretisation": {"elements_across": 1, "force_error": 1, "pmax_error": 1, "source": "estimate", "rolling_error": 2, "compliance_ratio": 2},
        },
    }
    yield reply(solution, b"\2", bytes(8))
    yield reply({"solutions": [{"status": {"code": 0, "name": "OK", "message": ""}, "result": solution}]}, b"\2", bytes(8))
    step = {**solution, "step": 1, "evidence": {"normal": statistics}}
    yield reply({**step, "element_division": {"$array": {"frame": 1, "dtype": "|u1", "shape": [1, 2]}},
                 **{name: array(2, 1, 2) for name in ("pressure", "traction_x", "traction_y", "pressure_by_approach")}}, b"\2\2", bytes(16))
    yield reply({"session": "0" * 32, "lease_seconds": 60, "step": 0, "bytes": 1, "ics": {"upper": use}})
    stress = {name: array(1, 1) for name in ("xx", "yy", "zz", "xy", "xz", "yz")}
    largest = {"von_mises": 0, "x": 0, "y": 0, "z": -1, "depth": 1}
    yield reply({"shape": [1], "stress": stress, "von_mises": array(1, 1), "largest": largest}, bytes(8))
    spec = documented("ic.get")
    yield reply({"key": "0" * 64, "origin": "built", "spec": spec, "table": array(1, 3, 3, 1, 1), "evidence": evidence}, bytes(72))


def arrays() -> Iterator[bytes]:
    numbers = np.arange(6.0).reshape(2, 3)
    yield bytes([1, 2, 3]) + message(numbers.tolist())
    yield bytes([1, 2, 3]) + message(array(1, 2, 3), numbers.tobytes())
    yield bytes([1, 2, 3]) + message({"$array": {"frame": 2, "dtype": "|u1", "shape": [2, 3]}}, b"", bytes(range(6)))
    yield bytes([0, 0]) + message([])
    yield bytes([0, 0]) + message(array(1, 0), b"")


def configurations() -> Iterator[bytes]:
    for path in sorted((ROOT / "configs").glob("*.json")):
        if path.name != "schema.json":
            yield path.read_bytes()


def ic_files() -> Iterator[bytes]:
    """Returns a header without the rest of its file; h5py makes an HDF5 file that is not from contactd."""
    header = b"contactd ic table, format 1, sha256 of the bytes after this block: " + b"0" * 64 + b"\n"
    yield header.ljust(512, b"\0") + b"\x89HDF\r\n\x1a\n"
    with h5py.File("strange", "w", driver="core", backing_store=False, userblock_size=512) as file:
        file["a"] = 1
        file.flush()
        yield bytes(file.id.get_file_image())


def creep_tables() -> Iterator[bytes]:
    """Headers of creep-force tables as core/src/creep_table/file/file_header.hpp defines them, with a/b and creepages."""
    none = (0, 0, 0, 0)
    box = ((0.0, 1.2, 1.2, 0.8), (0.6, 1.9, 1.5707963267948966, 1.3))
    for nu, cells, box_cells, bound_cells in [((0.28,), (4, 4, 4, 4), none, none), ((0.0, 0.25, 0.5), (4, 6, 4, 5), (4, 4, 4, 4), (1, 2, 1, 3))]:
        sizes = (1, 0, 64, len(nu), 4, *cells, *box_cells, *bound_cells)
        ranges = (-0.7, 0.7, 1.4, 0.17, 2, 0, *box[0], *box[1])
        header = b"contactd creep-force table\n".ljust(32, b"\0") + struct.pack("<17Q", *sizes)
        header += struct.pack("<22d", *ranges, *nu, *[0.0] * (8 - len(nu)))
        states = [(0.1, 0, 0, 0), (0.1, 0.3, -0.2, 0.1), (-0.5, 0, 1, 0), (0.7, 0, 0, 0.4), (0, 1e-5, 0, 0), (0.2, 1e9, -1e9, 1e9)]
        yield header.ljust(512, b"\0") + b"".join(struct.pack("<4d", *state) for state in states)
        yield header


def profile_files() -> Iterator[bytes]:
    """Returns a format's number, as profile_file.cpp reads it, and a rough wheel or rail in this format."""
    wheel = [(-68, 20), (-55, 28), (-41, 19), (-38, 11), (-30, 4), (-20, 1.6), (-10, 0.5), (0, 0), (20, -0.3), (40, -1.3), (60, -2.6)]
    rail = [(y, 0.006 * y * y + 1e-7 * y**4) for y in range(-36, 37, 4)]
    for number in (*range(15), 35, 73, 91, 137, 219):  # smoothed from five on, with additional options from ten on
        is_wheel = number % 5 in (0, 2)
        upwards = number % 5 in (2, 3)
        points = "".join(f"{y} {-z if upwards else z}\n" for y, z in (wheel if is_wheel else rail))
        if number % 5 < 2:
            keys = "shift.y = 0.5\nrotate = 1\nbound.y.min = 1\nbound.y.max = 0\nmirror.y = 0\nunits.len.f = 1000\nunits.ang.f = 57.3\n"
            head = f"header.begin\ntype = {int(is_wheel)} ! kind\nheader.end\nspline.begin\n{keys}point.begin\n"
            yield bytes([number]) + f"{head}{points}point.end\nspline.end\n".encode()
        elif upwards:
            yield bytes([number]) + f"Date=1\nColumnDef=X,Y\n\n{points}".encode()
        else:
            yield bytes([number]) + f"# y, z\n{points}".encode()


def contact_files() -> Iterator[bytes]:
    """Returns input files of the CONTACT program with groups of every kind, and a list of slices after an L."""
    bounds, load, elastic = "999 20 25 1 1e-5\n", "1. .1 0 0\n", ".28 .28 1. 1.\n"
    for digits, friction, more in [
        ("200100\n022020\n000001", ".3 .3\n", ""),
        ("202110\n422421 2\n3000001", ".3 .1 9. 0 0\n0. 1.\n0d .5 1.\n", "1. 0. 1. .4\n1 2 3 4\n0 1 1 1\n0 1 1 1\n.5\n"),
        ("203103\n3024029\n10000001\n0", "0 .2 30. 1 1 3\n-1 1d 0 0 1 1r\n", ""),
    ]:
        grid = "1\n2 2 -1 -1 1 1\n9 4\n0 0\n0 0\n1\n-1 1 -1 1\n"
        points = "2 1\n2\n1 1 2\n1 1 1\n2 0. .1\n9\n1 1 2\n0\n0\n0 1\n0\n" if digits[5] == "3" else ""
        head = f"3 1 2 MODULE\n{digits}\n{bounds}{load}{friction}{elastic}{more}"
        yield f"{head}{grid}{points}3 1 2\n001100\n100000\n101001\n{load}0\n".encode()
    for grid in ("-1\n1 1 1 1 1\n", "-6\n1 1 1 1 1 1\n", "3\n2 1 0 0 1 1\n2 1\n1 0 1 0 1\n0\n", "4\n1 1 0 0 1 1\n3 3\n1 2 3 4 5 6 7 8\n0 1 0 1 2 3 2 3\n"):
        yield f"3 MODULE\n200100\n022020\n400000\n{bounds}1 .9\n{load}.3 .3\n{elastic}{grid}".encode()
    profile = "0 1. 0. 0 2\n0 150d 30d 6d 2.\n-1 .5\n"
    for first, place in (("1203130", "0"), ("5203100", "1")):
        springs = "1 2 3 4 .5\n" if first[5] == "3" else ""
        yield (
            f"1 MODULE\n{first}\n1022035\n0000001\n{bounds}1\n-10d .3 .3\n{elastic}.2 .2 1. 90d0 8. 4. 9.\n{place} 0 0 0. 1e-6\n'a.slcs' {profile}"
            f"0 0 0 0 0 0\n{springs}1360. -70. 460. 1.\n'b.prw' {profile}0 0 1. 0 0 0\n1. 0 0 0 0 -1d\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 MODULE\n"
        ).encode()
    yield b"L0. 1000.\n2\n4 1 1\n2\n-1. 'a.prr'\n0. 'b.prr'\n1\n2\n-1. 0. 1. 2. -1\n0. 0. 1. 2. 999.\n"


def ic_contents() -> Iterator[bytes]:
    """Returns edits, as ic_content.cpp reads them: none, of an attribute, of a dataset."""
    for family in (0, 1):
        yield bytes([family])
        yield bytes([family, 1, 1, 2, 1, 0, 0, *struct.pack(">d", 0.25)])
        yield bytes([family, 1, 2, 3, 1, 2, 1, 2, 5]) + b"words"
        yield bytes([family, 0, 4 + family, 2, 0, 4, 3, 3, 2, 3, *struct.pack(">d", 1)])


def ic_imports() -> Iterator[bytes]:
    """Returns the one coefficient under an element of a half-space, in closed form; a family of it; a longitudinally
    uniform body of one strip."""
    errors = {f"evidence/error_{c}_{place}": 1e-3 for c in ("xx", "yy", "zz") for place in ("origin", "largest")}
    numbers = dict.fromkeys(("elements", "dofs", "processes", "errors_estimated"), 0)
    numbers |= {f"{stage}_seconds": 1.0 for stage in ("assembly", "setup", "solve", "total")}
    evidence = {f"evidence/{name}": value for name, value in numbers.items()} | errors
    evidence |= {"evidence/source": "fem", "evidence/version": "1", "evidence/scaled_error_xy": 1e-3, "evidence/scaled_error_xz": 1e-3}
    spec = {"spec/source": "fem", "spec/load_shape": "constant", "spec/dy_over_dx": 1.0, "spec/accuracy": 0.01}
    spec |= {"contactd_format": 2, **evidence}

    def under(nu: float) -> np.ndarray[Any, Any]:
        scale = 4 * math.log(1 + math.sqrt(2)) / (2 * math.pi)
        return np.diag([scale * (1 - nu / 2)] * 2 + [scale * (1 - nu)])

    def message_of(attributes: Any, **datasets: Any) -> bytes:
        arrays = [np.asarray(array, dtype="<f8") for array in datasets.values()]
        refer = {name: array(n, *a.shape) for n, (name, a) in enumerate(zip(datasets, arrays, strict=True), 1)}
        return message({"attributes": attributes, "datasets": refer}, *(a.tobytes() for a in arrays))

    one = {**spec, "spec/body": "half_space", "spec/any_nu": 0, "spec/nu": 0.28}
    yield message_of(one, influence_coefficients=under(0.28).reshape(3, 3, 1, 1))
    points = [0.0, 0.3, 0.3, 0.49]
    family = np.stack([under(nu).reshape(3, 3, 1, 1) for nu in points])
    several = {**spec, "spec/body": "half_space", "spec/any_nu": 1, "evidence/family_nu": points, "evidence/interpolation_error": 0.01}
    yield message_of(several, influence_coefficients=family[0], influence_coefficients_family=family)
    section = {"section_order": 4, "wavenumbers": 5} | dict.fromkeys(("section_error", "mesh_error", "wavenumber_error", "end_error", "reciprocity_defect"), 0.001)
    uniform = {**one, "spec/body": "longitudinally_uniform", "transform/xi0": 0.01, "transform/wavenumbers": [0.0, 0.1, 0.5, 2.0, 6.0]}
    uniform |= {f"evidence/{name}": value for name, value in section.items()}
    slab = [8, 20.0, 40.0, 1, 0, 0]
    yield message_of(uniform, **{"spec/section": slab, "transform": [[2, 0, 2, 0, 0, 2]] * 5, "frames": [[0, 0, 0]]})


def outlines() -> Iterator[bytes]:
    """Returns sections of every shape; outlines of lines, arcs, splines and holes, with or without strips on them."""

    def point(y: float, z: float) -> Any:
        return {"y": y, "z": z}

    def line(y: float, z: float, **more: Any) -> Any:
        return {"line": {"to": point(y, z)}, **more}

    def arc(y: float, z: float, radius: float, **more: Any) -> Any:
        return {"arc": {"to": point(y, z), "radius": radius}, **more}

    def hole(y: float, z: float, radius: float) -> Any:
        return {"start": point(y + radius, z), "parts": [arc(y - radius, z, -radius), arc(y + radius, z, -radius)]}

    below = [line(6, -4), line(-6, -4, clamped=True), line(-5, 0)]
    spline = {"spline": {"through": [point(-2, 0.5), point(1, -0.4), point(3, 0.3), point(5, 0)]}}
    tops = [[line(5, 0)], [arc(5, 0, 13)], [arc(5, 0, -9)], [spline], [line(-1, 0), arc(1, 0, -1.5), line(5, 0)]]
    outsides = [{"start": point(-5, 0), "parts": [*top, *below]} for top in tops]
    holes = [hole(-2, -2, 0.8), hole(2, -2.2, 1)]
    shapes: list[Any] = [{"outline": {"outside": outside, "from": 2}} for outside in outsides]
    shapes += [{"outline": {"outside": outsides[0], "holes": holes, "from": 2}}]
    shapes += [{"outline": {"outside": outsides[1], "holes": holes, "carrier": 2, "part": 1, "from": 0.5}}]
    shapes += [
        {"rail_60e1": {"from": 5}, "size": 0.2}, {"rail_60e1": {"inclination": 0.025, "support": "foot"}, "size": 0.2},
        {"rim_s1002": {"thickness": 30}, "size": 0.1}, {"edge_block": {"width": 8, "height": 5, "edge_distance": 0.3}},
        {"groove": {"radius": 3, "depth": 2, "width": 10, "height": 6}}, {"round_end": {"radius": 2, "length": 3}},
        {"disc": {"radius": 3, "core": 0.5}}, {"plate_hole": {"radius": 2, "plate_radius": 5}}, {"slab": {"thickness": 1, "width": 9}},
    ]  # fmt: skip
    points = [[y, 0.01 * y * y] for y in range(-6, 7, 2)]
    profiles: list[Any] = [{"points": points, "smoothing_length": 3}, {"points": points}, {"arc": {"radius": 80, "from": -6, "to": 6}}]
    shapes += [{"profile_section": {"kind": "rail", "profile": profile, "depth": 6}} for profile in profiles]
    for number, shape in enumerate(shapes):
        ics = {"source": "fem", "body": "longitudinally_uniform", "accuracy": (1e-2, 1e-3, 1e-1)[number % 3], "section": {**shape, "turn": number % 2}}
        grid = {"nx": 3, "ny": 1 + number % 4, "dx": 0.5, "dy": 0.5}
        yield message({"material": {"G": 1, "nu": (0.28, 0.45)[number % 2]}, "grid": grid, "ics": ics})


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "json.dict").write_text(dictionary())
    kinds = {
        "request": requests, "session": sessions, "reply": replies, "array": arrays, "config": configurations,
        "ic_file": ic_files, "ic_content": ic_contents, "ic_import": ic_imports, "profile_file": profile_files,
        "creep_table": creep_tables,
        "contact_file": contact_files, "outlines": outlines,
    }  # fmt: skip
    for target, inputs in kinds.items():
        (folder / target).mkdir(exist_ok=True)
        for number, content in enumerate(inputs()):
            (folder / target / f"seed-{number:02}").write_bytes(content)


if __name__ == "__main__":
    main()

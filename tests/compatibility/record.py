"""Records what this version says and writes: python3 tests/compatibility/record.py BIN, once for each release, by whoever makes it.

Nothing that was recorded is written again: what old clients sent, and old stores hold, does not change.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "client" / "python")]

import contactd  # noqa: E402
from compatibility.exchanges import RECORDED, Exchange, asked, written  # noqa: E402
from contactd import FemIcs, Friction, Grid, LocalDaemon, Material, Paraboloid, Rolling  # noqa: E402
from support.raw import RawClient  # noqa: E402

STEEL = {"G": 82000, "nu": 0.28}
CONTACT = {
    "grid": {"nx": 12, "ny": 10, "dx": 1.2, "dy": 1.2}, "bodies": {"upper": STEEL}, "ics": {"source": "analytic"},
    "gap": {"paraboloid": {"Rx": 460, "Ry": 300}}, "Fn": 80000,
}  # fmt: skip
ROLLING = {"mu": 0.3, "rolling": {"xi": 0.001, "phi": 0.0002}}
SHIFT = {"mu": 0.3, "rigid_shift": [0.004, 0.001]}
LAYERS = {"source": "analytic", "body": "layered", "layers": [{"thickness": 2, "G": 1, "nu": 0.5}], "base": {"rigid": True}}
WHEEL = {"setup": {"dx": 1, "dy": 1}, "state": {"position": {"y": 3}, "velocity": {"x": 20000, "pitch": -43.478}, "Fz": 80000}}
TABLE = {"material": STEEL, "grid": {"nx": 4, "ny": 4, "dx": 0.8, "dy": 0.8}, "ics": {"source": "analytic"}}
REQUESTS: list[tuple[str, dict[str, Any]]] = [
    ("contact.solve", CONTACT),
    ("contact.solve", {**CONTACT, "friction": ROLLING}),
    ("contact.solve", {**CONTACT, "friction": SHIFT, "fields": ["pressure", "traction_x"]}),
    ("contact.solve", {**CONTACT, "friction": {**ROLLING, "kinetic": {"mu": 0.2, "slip_velocity": 500}}, "fields": []}),
    ("contact.solve", {**CONTACT, "friction": ROLLING, "derivatives": True, "fields": []}),
    ("contact.solve", {**CONTACT, "friction": ROLLING, "model": "fastsim", "fields": []}),
    ("contact.solve", {**CONTACT, "friction": SHIFT, "model": "hertz", "fields": []}),
    ("contact.solve", {**CONTACT, "bodies": {"upper": {"ics": LAYERS}, "lower": {"rigid": True}}, "Fn": 50, "fields": []}),
    ("contact.solve_many", {"problems": [{**CONTACT, "Fn": force, "fields": []} for force in (20000, 40000)]}),
    ("ic.get", TABLE),
    ("wheelrail.solve", {**WHEEL, "fields": []}),
    ("wheelrail.geometry", {"setup": WHEEL["setup"], "contacts": {"shifts": [0, 3]}}),
    ("session.open", {"grid": CONTACT["grid"], "bodies": CONTACT["bodies"], "ics": CONTACT["ics"], "gap": CONTACT["gap"]}),
    ("session.step", {"step": 1, "Fn": 50000, "friction": ROLLING, "fields": ["pressure"]}),
    ("session.close", {}),
    ("contact.solve", {**CONTACT, "Fn": -1}),
    ("server.info", {}),
]


def exchanges_with(raw: RawClient) -> list[Exchange]:
    found: list[Exchange] = []
    session = ""
    for number, (method, params) in enumerate(REQUESTS):
        given = {**params, "session": session} if method.startswith("session.") and method != "session.open" else params
        found.append(asked(raw, {"contactd": 1, "id": f"r{number}", "method": method, "params": given}, []))
        if method == "session.open":
            session = found[-1].answer["result"]["session"]
    return found


def main() -> None:
    folder = RECORDED / contactd.__version__
    folder.mkdir(parents=True)
    with LocalDaemon(Path(sys.argv[1]) / "contactd") as daemon:
        with RawClient(daemon.endpoint) as raw:
            (folder / "exchanges.gz").write_bytes(written(exchanges_with(raw)))
        with daemon.client() as client:
            table = client.get_ic(Material(**STEEL), Grid(3, 3, 0.8, 0.8), FemIcs("paper-test1", L_over_h=20))
            (folder / "store").mkdir()
            (kept,) = (daemon.folder / "store").glob("*.h5")
            (folder / "store" / kept.name).write_bytes(kept.read_bytes())
            solution = client.solve(
                grid=Grid(12, 10, 1.2, 1.2), upper=Material(**STEEL), gap=Paraboloid(460, 300), Fn=8e4,
                friction=Friction(0.3, rolling=Rolling(xi=1e-3)),
            )  # fmt: skip
            solution.save(folder / "solution.h5")
    told = {"zz": table["zz"].tolist(), "pmax": solution.pmax, "Fx": solution.Fx}
    (folder / "values.json").write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()

"""Lists the values that CONTACT prints of a case, by both interfaces to its input files: contact_file.run, which
`contactctl contact` uses, and the drop-in library. Quantities have the same names and shapes, in mm and N on body
1."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import contactd
from contactd.contact_files.case import Case
from contactd.contact_files.case_results import StressField
from contactd.contact_files.input_file import name_and_text
from contactd.contact_files.named_files import NamedFiles
from contactd.contact_files.runner import Runner, chains_of
from contactd.contact_files.solved_case import SolvedCase
from support.contact_text import kept, text_of
from support.drop_in import ALL, DropIn

__all__ = ["Answers", "differing", "pairs"]

Floats = npt.NDArray[np.float64]
Quantities = dict[str, Floats]

_PREVIOUS, _ESTIMATE = 1970, 1983  #: the flags of P and I
_STRESSES = (13, 14, 15, 17, 18, 21)  #: columns of xx, xy, xz, yy, yz, zz
_EQUIVALENT = (7, 8, 9, 10, 11, 12)  #: of the mean, von Mises', Tresca's and the principal stresses, largest first
_MOVED = (4, 5, 6)  #: of displacements
_NEAR = 1e-12  #: of the largest number of a quantity: the interface of the drop-in library rounds


@dataclass(frozen=True)
class Answers:
    """A case, one way.

    Attributes:
        status: The outcome, as of the runner.
        sentence: Why there is no solution, or what is wrong with it.
        quantities: Numbers by the names of what they are.
        least: What is smaller is printed as 0, by the names of quantities.
    """

    status: str
    sentence: str = ""
    quantities: Quantities = field(default_factory=dict)
    least: Mapping[str, float] = field(default_factory=dict)


def pairs(path: Path, folder: Path) -> Iterator[tuple[Case, Answers, Answers]]:
    """Yields each case of a file with its answers by contact_file.run and by the drop-in library; histories follow
    each other, each in its order. Files for the library are written into `folder`."""
    with contactd.local(config={"workers": 1}) as client:
        _, text = name_and_text(path)
        cases = client.read_contact_file(text).cases
        runner = Runner(client, text, cases, NamedFiles(path.parent), fields=[])
        for ire, chain in enumerate(chains_of(cases), 1):
            element = DropIn(ire, chain[0].module)
            try:
                for solved in runner.run(chain):
                    yield solved.case, _of_file(solved), _of_drop_in(element, solved.case, path.parent, folder, client)
            finally:
                element.close()


def differing(one: Answers, other: Answers) -> list[str]:
    """Returns names of the quantities that differ."""
    if one.status != other.status:
        return ["status"]
    names = sorted({*one.quantities, *other.quantities})
    return [name for name in names if not _is_same(name, one, other)]


def _is_same(name: str, one: Answers, other: Answers) -> bool:
    if name not in one.quantities or name not in other.quantities:
        return False
    first, second = one.quantities[name], other.quantities[name]
    if first.shape != second.shape or not (np.isfinite(first).all() and np.isfinite(second).all()):
        return False
    if (least := one.least.get(name)) is not None:
        first, second = (np.where(np.abs(values) < least, 0, values) for values in (first, second))
    compared_with = [first, second]
    if name.endswith("slip"):  # where surfaces stick, slip is the rounding error of the rigid slip
        prefix = name.removesuffix("slip").removesuffix("rigid ")
        compared_with += [one.quantities.get(f"{prefix}{motion}", first) for motion in ("rigid slip", "creepages")]
    largest = max(np.max(np.abs(values), initial=0) for values in compared_with)
    return bool(np.max(np.abs(first - second), initial=0) <= _NEAR * largest)


# By contact_file.run.


def _of_file(solved: SolvedCase) -> Answers:
    if solved.solution is None:
        return Answers("read" if solved.status == "read" else "refused", solved.sentence)
    if solved.case.module == 1:
        return Answers(solved.status, solved.sentence, _on_rails(solved))
    return Answers(solved.status, solved.sentence, _basic(solved), _least(solved))


def _least(solved: SolvedCase) -> dict[str, float]:
    (patch,) = solved.answer.patches
    eps = solved.case.values["EPS"]
    force = eps * patch.numbers["FN"] * patch.mu[0] / 2
    return {"forces": force, "moment": force, "creepages": eps * max(map(abs, _motion(solved)[:2]))}


def _motion(solved: SolvedCase) -> list[float]:
    """Returns creepages or the shift, at the centre of spin, and spin."""
    values, numbers = solved.case.values, solved.answer.numbers
    if solved.case.digits["T"] == 0:
        return [0.0] * 3
    found = [next((numbers[name] for name in numbers if name.endswith(f" {axis}")), None) for axis in "XY"]
    prescribed = [values.get("CKSI", 0.0), values.get("CETA", 0.0)]
    return [*(there if one is None else one for one, there in zip(found, prescribed)), values["CPHI"]]


def _basic(solved: SolvedCase) -> Quantities:
    (patch,), numbers = solved.answer.patches, solved.answer.numbers
    found = {
        "forces": _floats(*(numbers[name] for name in ("FN", "FX", "FY"))), "moment": _floats(numbers["MZ"]),
        "creepages": _floats(*_motion(solved)), **_of_contact(solved, patch, solved.answer.contact),
    }  # fmt: skip
    if solved.case.values["IPOTCN"] < 0:
        found["Hertz"] = _named(patch, "A1", "B1", "AA", "BB")
    return found


def _of_contact(solved: SolvedCase, patch: Any, solution: Any) -> Quantities:
    """Returns values that contacts of both modules have."""
    numbers, grid, arrays, tangential = patch.numbers, patch.grid, patch.arrays, solved.case.digits["T"]
    counts = [numbers[name] for name in ("NPOT", "NCON", "NADH", "NSLIP")]
    along, across = (numbers["SPINXO"], numbers["SPINYO"]) if solved.case.module == 1 else (0.0, 0.0)
    temperature = solution.temperature

    def fields(*names: str) -> Floats:
        return np.stack([arrays[name] for name in names])

    found = {
        "approach": _floats(numbers["APPROACH"]),
        "largest pressure": _floats(numbers["PMAX"]),
        "largest traction": _floats(np.max(np.hypot(arrays["PX"], arrays["PY"]))),
        "numbers of elements": _floats(*counts, numbers.get("NPLAST", 0)), "areas": _floats(*counts[1:]) * grid.dx * grid.dy,
        "temperatures": _floats(*((temperature.largest_upper, temperature.largest_lower) if temperature else (0, 0))),
        "grid": _floats(grid.nx, grid.ny, grid.x[0] + along, grid.y[0] + across, grid.dx, grid.dy),
        "division": arrays["IGS"], "pressure": arrays["PN"], "traction": fields("PX", "PY"), "slip": fields("SX", "SY"),
        "distance": arrays["H"], "displacement": fields("UX", "UY", "UN") * (arrays["IGS"] > 0),
    }  # fmt: skip
    if tangential > 0:
        found |= {"friction": arrays["MU"], "rigid slip": fields("WX", "WY")}
    if "TAUCRT" in arrays:
        found["layer"] = fields("TAUCRT", "UPLSX", "UPLSY")
    if "TEMP1" in arrays:
        found["surface temperature"] = fields("TEMP1", "TEMP2")
    for number, block in enumerate(map(StressField, patch.blocks), 1):
        found[f"stresses {number}"] = block.stress
        found[f"equivalent stresses {number}"] = np.stack([block.hydrostatic, block.von_mises, block.tresca, *block.principal[::-1]])
        found[f"displacement below {number}"] = np.stack([block.block[f"U{axis}"] for axis in "XYZ"])
    return found


def _on_rails(solved: SolvedCase) -> Quantities:
    numbers, wheel = solved.answer.numbers, solved.answer.wheelrail
    assert wheel is not None
    moments, deflection = wheel.forces.rail, wheel.rail_deflection
    found = {
        "patches": _floats(len(solved.answer.patches)), "height": _floats(wheel.z), "pitch rate": _floats(wheel.pitch_rate),
        "track forces": _floats(*(numbers[f"F{axis}(TR)"] for axis in "XYZ")),
        "wheelset forces": _floats(*(numbers[f"F{axis}(WS)"] for axis in "XYZ")),
        "moments": _floats(moments.Mx, moments.My, moments.Mz),
    }  # fmt: skip
    for number, (patch, solution) in enumerate(zip(solved.answer.patches, solved.patches), 1):
        bar = "BAR_" if "BAR_FN" in patch.numbers else ""
        own = {
            "forces": _named(patch, *(f"{bar}{name}" for name in ("FN", "FX", "FS"))), "moment": _named(patch, "MN"),
            "creepages": _named(patch, "CKSI", "CETA", "CPHI"),
            "reference": _named(patch, "XCP(TR)", "YCP(TR)", "ZCP(TR)", "DELTCP(TR)"),
            "place on the rail": _named(patch, "YCP(R)", "ZCP(R)"), "place on the wheel": _named(patch, "XCP(W)", "YCP(W)", "ZCP(W)"),
            "deflection": _floats(deflection.y, deflection.z) if deflection else np.zeros(2),
            **_of_contact(solved, patch, solution),
        }  # fmt: skip
        found |= {f"patch {number}: {name}": values for name, values in own.items()}
    return found


def _named(patch: Any, *names: str) -> Floats:
    return _floats(*(patch.numbers[name] for name in names))


def _floats(*values: Any) -> Floats:
    return np.array(values, dtype=np.float64)


# Computes it by the drop-in library.


def _of_drop_in(element: DropIn, case: Case, origin: Path, folder: Path, client: Any) -> Answers:
    """A file contains the first case of a history: P and I, which continue it, are set by their flags."""
    if case.digits["R"] in (2, 3):
        return Answers("read")
    path = folder / "case.inp"
    path.write_text(text_of(case, origin))
    (again,) = client.read_contact_file(path.read_text()).cases
    assert kept(again, origin) == kept(case, origin), "the text of the case has lost something"
    if element.read(path) != 0:
        return Answers("refused", element.sentence)
    element.flag(_PREVIOUS, case.digits["P"])
    element.flag(_ESTIMATE, case.digits["I"])
    status, sentence = element.calculate()
    if status == "refused":
        return Answers(status, sentence)
    found = _read_rails(element, case) if element.is_on_rails else _read_basic(element, case)
    return Answers(status, sentence, found)


def _read_basic(element: DropIn, case: Case) -> Quantities:
    found = _read_contact(element, 1, case)
    if case.values["IPOTCN"] < 0:
        found["Hertz"] = element.list("cntc_gethertzcontact", 4, 1)
    return found


def _read_rails(element: DropIn, case: Case) -> Quantities:
    forces = element.list("cntc_getglobalforces", 18, ALL)
    patches = element.integer("cntc_getnumcontactpatches")
    found = {
        "patches": _floats(patches), "height": element.list("cntc_getwheelsetposition", 3)[2:],
        "pitch rate": element.list("cntc_getwheelsetvelocity", 6)[5:],
        "track forces": forces[:3], "wheelset forces": forces[6:9], "moments": forces[15:18],
    }  # fmt: skip
    for number in range(1, patches + 1):
        place = element.list("cntc_getcontactlocation", 38, number)
        own = {**_read_contact(element, number, case), "reference": place[:4], "place on the rail": place[5:7],
               "place on the wheel": place[9:12], "deflection": place[17:19]}  # fmt: skip
        found |= {f"patch {number}: {name}": values for name, values in own.items()}
    return found


def _read_contact(element: DropIn, icp: int, case: Case) -> Quantities:
    grid = element.list("cntc_getpotcontact", 6, icp)
    nx, ny = (int(count) for count in grid[:2])
    count = nx * ny

    def fields(*codes: int) -> Floats:
        return np.stack([element.field(code, icp, count) for code in codes]).reshape(-1, ny, nx)

    forces = element.reals("cntc_getcontactforces", 4, icp)
    division = element.division(icp, count)
    states = [int(np.count_nonzero(division == state)) for state in (1, 2, 3)]
    found = {
        "forces": forces[:3], "moment": forces[3:], "approach": element.reals("cntc_getpenetration", 1, icp),
        "creepages": element.reals("cntc_getcreepages", 3, icp),
        "largest pressure": element.reals("cntc_getmaximumpressure", 1, icp),
        "largest traction": element.reals("cntc_getmaximumtraction", 1, icp),
        "numbers of elements": _floats(count, sum(states), *states), "areas": element.reals("cntc_getcontactpatchareas", 3, icp),
        "temperatures": element.reals("cntc_getmaximumtemperature", 2, icp),
        "grid": grid, "division": division.reshape(ny, nx).astype(float), "pressure": fields(5)[0], "traction": fields(3, 4),
        "slip": fields(15, 16), "distance": fields(1)[0], "displacement": fields(7, 8, 9),
    }  # fmt: skip
    if case.digits["T"] > 0:
        found |= {"friction": fields(2)[0], "rigid slip": fields(22, 23)}
    if case.digits["M"] == 4 and case.values["TAU_C0"] > 0:
        found["layer"] = fields(11, 12, 13)
    if case.digits["H"] > 0 and case.digits["T"] == 3:
        found["surface temperature"] = fields(20, 21)
    return found | _read_stresses(element, icp, case)


def _read_stresses(element: DropIn, icp: int, case: Case) -> Quantities:
    if case.digits["S"] == 0:
        return {}
    element.stresses(icp)
    found: Quantities = {}
    for number in range(1, len(case.subsurface) + 1):
        for name, columns in (("stresses", _STRESSES), ("equivalent stresses", _EQUIVALENT), ("displacement below", _MOVED)):
            found[f"{name} {number}"] = element.columns(icp, number, columns)
    return found

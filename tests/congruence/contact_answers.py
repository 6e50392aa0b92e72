"""What CONTACT prints of a case, from both translations of its input files: that of Python, which `contactctl contact`
uses, and that of the drop-in library. Quantities have the same names and shapes, in mm and N on body 1."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import contactd
from contactd import contact_files
from contactd.contact_files.answers.basic_results import BasicResult
from contactd.contact_files.answers.elements import Elements
from contactd.contact_files.answers.rail_results import RailResult
from contactd.contact_files.answers.subsurface import StressField
from contactd.contact_files.case import Case
from contactd.contact_files.profile_files import ProfileFiles
from contactd.contact_files.runner import Outcome, Runner, chains_of
from support.contact_text import kept, text_of
from support.drop_in import ALL, DropIn

__all__ = ["Answers", "differing", "pairs"]

Floats = npt.NDArray[np.float64]
Quantities = dict[str, Floats]

_PREVIOUS = 1970  #: the flag of P
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
    """Each case of a file with its answers by Python and by the drop-in library; histories one after the other, each in its
    order. Files for the library are written into `folder`."""
    with contactd.local(config={"workers": 1}) as client:
        runner = Runner(client, ProfileFiles(path.parent, client), "exact")
        for ire, chain in enumerate(chains_of(contact_files.read(path, client).cases), 1):
            element = DropIn(ire, chain[0].module)
            try:
                for outcome in runner.run(chain):
                    yield outcome.case, _of_python(outcome), _of_drop_in(element, outcome, path.parent, folder, client)
            finally:
                element.close()


def differing(one: Answers, other: Answers) -> list[str]:
    """Names of the quantities that are not the same."""
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
    if name.endswith("slip"):  # where surfaces stick, slip is what rounding leaves of the rigid slip
        prefix = name.removesuffix("slip").removesuffix("rigid ")
        compared_with += [one.quantities.get(f"{prefix}{motion}", first) for motion in ("rigid slip", "creepages")]
    largest = max(np.max(np.abs(values), initial=0) for values in compared_with)
    return bool(np.max(np.abs(first - second), initial=0) <= _NEAR * largest)


# By Python.


def _of_python(outcome: Outcome) -> Answers:
    result = outcome.result
    if result is None:
        return Answers("read" if outcome.status == "read" else "refused", outcome.sentence)
    if isinstance(result, BasicResult):
        return Answers(outcome.status, outcome.sentence, _basic(result), _least(result))
    return Answers(outcome.status, outcome.sentence, _on_rails(result))


def _least(result: BasicResult) -> dict[str, float]:
    eps = result.contact.case.values["EPS"]
    force = eps * result.solution.Fn * result.contact.friction_unit / 2
    return {"forces": force, "moment": force, "creepages": eps * max(map(abs, result.creepage))}


def _basic(result: BasicResult) -> Quantities:
    contact, solution, numbers = result.contact, result.solution, result.numbers
    temperature = solution.temperature
    motion = [*result.creepage, contact.case.values["CPHI"]] if contact.case.digits["T"] > 0 else [0.0] * 3
    found = {
        "forces": _floats(numbers["FN"], result.fx, result.fy), "moment": _floats(result.mz),
        "approach": _floats(numbers["APPROACH"]), "creepages": _floats(*motion),
        **_of_numbers(numbers, result.elements),
        "temperatures": _floats(*((temperature.largest_upper, temperature.largest_lower) if temperature else (0, 0))),
        **_elements(result.elements, contact.case.digits["T"]), **_stresses(result.stresses),
    }  # fmt: skip
    if contact.area.ellipse is not None:
        ellipse = contact.area.ellipse
        found["Hertz"] = _floats(ellipse.a1, ellipse.b1, ellipse.aa, ellipse.bb)
    return found


def _of_numbers(numbers: Mapping[str, float], elements: Elements) -> Quantities:
    counts = [numbers[name] for name in ("NPOT", "NCON", "NADH", "NSLIP")]
    area = elements.grid.dx * elements.grid.dy
    return {
        "largest pressure": _floats(numbers["PMAX"]), "largest traction": _floats(np.max(elements.traction_size)),
        "numbers of elements": _floats(*counts, numbers.get("NPLAST", 0)), "areas": _floats(*counts[1:]) * area,
    }  # fmt: skip


def _elements(elements: Elements, tangential: int, counted_from: tuple[float, float] = (0.0, 0.0)) -> Quantities:
    grid, is_in, (along, across) = elements.grid, elements.division > 0, counted_from
    found = {
        "grid": _floats(grid.nx, grid.ny, grid.x[0] + along, grid.y[0] + across, grid.dx, grid.dy), "division": np.asarray(elements.division, float),
        "pressure": elements.pressure, "traction": np.stack(elements.traction), "slip": np.stack(elements.slip),
        "distance": elements.h, "displacement": elements.displacement * is_in,
    }  # fmt: skip
    if tangential > 0:
        found |= {"friction": elements.mu, "rigid slip": np.stack(elements.rigid_slip)}
    if elements.layer is not None:
        found["layer"] = np.stack(elements.layer)
    if elements.temperature is not None:
        found["surface temperature"] = np.stack(elements.temperature)
    return found


def _stresses(blocks: Sequence[StressField]) -> Quantities:
    found: Quantities = {}
    for number, block in enumerate(blocks, 1):
        found[f"stresses {number}"] = block.stress
        found[f"equivalent stresses {number}"] = np.stack([block.hydrostatic, block.von_mises, block.tresca, *block.principal[::-1]])
        found[f"displacement below {number}"] = np.moveaxis(block.displacement, -1, 0)
    return found


def _on_rails(result: RailResult) -> Quantities:
    forces, solution = result.solution.forces, result.solution
    found = {
        "patches": _floats(len(result.patches)), "height": _floats(solution.z), "pitch rate": _floats(solution.pitch_rate),
        "track forces": _floats(forces.track.Fx, forces.track.Fy, forces.track.Fz),
        "wheelset forces": _floats(forces.wheelset.Fx, forces.wheelset.Fy, forces.wheelset.Fz),
        "moments": _floats(forces.rail.Mx, forces.rail.My, forces.rail.Mz),
    }  # fmt: skip
    deflection = solution.rail_deflection
    for number, patch in enumerate(result.patches, 1):
        numbers, elements, reference = result.numbers_of(patch), result.elements_of(patch), patch.place.reference
        temperature, is_row = patch.solution.temperature, "BAR_FN" in numbers
        names = ("BAR_FN", "BAR_FX", "BAR_FS") if is_row else ("FN", "FX", "FS")
        own = {
            "forces": _floats(*(numbers[name] for name in names)), "moment": _floats(numbers["MN"]),
            "approach": _floats(numbers["APPROACH"]), "creepages": _floats(*(numbers[name] for name in ("CKSI", "CETA", "CPHI"))),
            "reference": _floats(reference.x, reference.y, reference.z, reference.angle),
            "place on the rail": _floats(*result.on_rail(patch)), "place on the wheel": _floats(*result.on_wheel(patch)),
            "deflection": _floats(deflection.y, deflection.z) if deflection else np.zeros(2),
            "temperatures": _floats(*((temperature.largest_upper, temperature.largest_lower) if temperature else (0, 0))),
            **_of_numbers(numbers, elements),
            **_elements(elements, result.contact.case.digits["T"], result.spin_centre(patch)),
            **_stresses(result.stresses_of(patch)),
        }  # fmt: skip
        found |= {f"patch {number}: {name}": values for name, values in own.items()}
    return found


def _floats(*values: Any) -> Floats:
    return np.array(values, dtype=np.float64)


# By the drop-in library.


def _of_drop_in(element: DropIn, outcome: Outcome, origin: Path, folder: Path, client: Any) -> Answers:
    """A file has the first case of a history: P, by which it goes on, is set by its flag."""
    case = outcome.case
    if case.digits["R"] in (2, 3):
        return Answers("read")
    path = folder / "case.inp"
    path.write_text(text_of(case, origin))
    (again,) = contact_files.read(path, client).cases
    assert kept(again, origin) == kept(case, origin), "the text of the case has lost something"
    if element.read(path) != 0:
        return Answers("refused", element.sentence)
    element.flag(_PREVIOUS, case.digits["P"])
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

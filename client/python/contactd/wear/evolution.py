"""The loop from states to worn profiles: contacts on the profile as it is, what they take off, a step, and again."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import numpy.typing as npt

from ..client import Client
from ..errors import InvalidArgument, invalid
from ..values.params import params_of
from ..values.profile_shapes import ProfilePoints
from ..values.wheel_rail.params import STEEL
from .filters import exponential_step, smoothed
from .places import rows_on_rail, rows_on_wheel
from .section import Section, deposit
from .stability import LoadedRows, Stiffness
from .steps import WornStep
from .study import WearStudy

__all__ = ["evolve"]

Array = npt.NDArray[np.float64]

_KM = 1e6  #: mm
_RADIUS = 460.0  #: nominal radius where a set-up names none (mm)
_FEW = 0.1  #: of the states
_MOST_BY_FEW = 0.9  #: of the area that few states may carry without a warning


def evolve(
    client: Client,
    study: WearStudy,
    steps: list[WornStep] | None = None,
    *,
    workers: int = 2,
    on_progress: Callable[[float, str], None] | None = None,
) -> Iterator[WornStep]:
    """Yields a step after the other, until the study's end. With the `steps` of a run before it goes on behind the last one,
    as if it had never stopped; else the first one is the new section.

    `workers` requests are on their way at a time; `on_progress` hears what share is done, and a sentence. Raises
    InvalidArgument naming the state, such as ``states[3]``, whose contact cannot be solved or lies beyond the section's end.
    """
    place = _Place(client, study)
    done = list(steps or ())
    if not done:
        points = Section.of(place.points, study.wears, study.spacing).points
        done.append(WornStep(0, 0.0, points, np.zeros(0), np.zeros(0)))
        yield done[0]
    new, last = Section(done[0].points, study.wears), done[-1]
    while last.distance < study.until:
        share = last.distance / study.until

        def tell(part: int, share: float = share, number: int = last.number + 1) -> None:
            if on_progress is not None:
                on_progress(share, f"step {number}: {part} of {len(study.states)} states")

        last = _next(new, last, study, place, _answers(client, study, place, last, workers, tell))
        yield last


class _Place:
    """Where profiles lie, as the daemon says it of the new ones; it stays."""

    def __init__(self, client: Client, study: WearStudy) -> None:
        setup = study.setup_params()
        placed = getattr(client.placed_profiles(study.setup), setup.get("side", "right"))
        self.points: Array = np.asarray(getattr(placed, study.wears), dtype=np.float64)
        self.left = setup.get("side") == "left"
        self.wheel_origin = float(placed.wheel_origin)
        self.rail_origin = (float(placed.rail_origin.y), float(placed.rail_origin.z))
        self.radius = float(setup.get("wheelset", {}).get("nominal_radius", _RADIUS))
        self.modulus = _modulus(setup.get("bodies", {}))

    def profiles(self, study: WearStudy, points: Array) -> dict[str, Any]:
        """The fields of a set-up that has a section of these points."""
        profile = params_of(ProfilePoints(points))
        if study.wears == "wheel":
            return {"wheel": profile}
        y, z = self.rail_origin
        return {"rail": profile, "track": {**study.setup_params().get("track", {}), "rail_origin": {"y": y, "z": z}, "cant": 0.0}}


def _modulus(bodies: Mapping[str, Any]) -> float:
    """E*, with 1/E* = sum (1 - nu)/(2 G)."""
    upper = bodies.get("upper", params_of(STEEL))
    both = (upper, bodies.get("lower", upper))
    return 1 / sum(float((1 - body["nu"]) / (2 * body["G"])) for body in both if "G" in body)


def _answers(
    client: Client, study: WearStudy, place: _Place, last: WornStep, workers: int, tell: Callable[[int], None]
) -> list[dict[str, Any]]:
    """The answers of all states, in their order, whoever ends first."""
    requests = study.params(place.profiles(study, last.points))

    def ask(i: int) -> dict[str, Any]:
        try:
            return client.call("wheelrail.solve", requests[i])
        except InvalidArgument as error:
            raise invalid(f"states[{i}]", f"cannot be solved: {error}") from error

    found = []
    with ThreadPoolExecutor(workers) as pool:
        try:
            for answer in pool.map(ask, range(len(requests))):
                found.append(answer)
                tell(len(found))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return found


def _next(new: Section, last: WornStep, study: WearStudy, place: _Place, answers: list[dict[str, Any]]) -> WornStep:
    section = Section(last.points, study.wears)
    edges = section.edges(study.spacing)
    size = float(edges[1] - edges[0])
    total = sum(one.weight for one in study.states)
    rates = np.zeros((len(answers), len(edges) - 1))  # what a km, or a passage, of this state takes off
    contacts: list[LoadedRows] = []
    warnings: list[str] = []
    T_gamma = T_gamma_with_spin = pmax = 0.0
    for i, (one, answer) in enumerate(zip(study.states, answers)):
        weight = one.weight / total
        try:
            rates[i] = _rate(answer, section, edges, study, place, i)
        except InvalidArgument as error:
            raise invalid(f"states[{i}]", f"cannot be placed: {error}") from error
        rates[i] *= weight
        contacts += _loaded_rows(answer, weight)
        for patch in answer.get("patches", ()):
            wear = patch["solution"].get("wear", {})
            T_gamma += weight * wear.get("T_gamma", 0.0)
            T_gamma_with_spin += weight * wear.get("T_gamma_with_spin", 0.0)
            pmax = max(pmax, patch["solution"]["pmax"])
        if not answer["converged"]:
            warnings.append(f"states[{i}] did not converge.")
    areas = rates.sum(axis=1) * size
    rate = rates.sum(axis=0)
    if not areas.sum() > 0:
        raise invalid("states", "wear nothing off: no contact of them slips, or the law is zero there")
    stiffness = Stiffness(contacts, place.modulus)
    depths, distance, smoothing = _step(rate, size, study, study.until - last.distance, stiffness, place.modulus, warnings)
    area = float(depths.sum() * size)
    centres = 0.5 * (edges[1:] + edges[:-1])
    worn = section.worn(np.interp(section.lengths, centres, depths), area)
    if _is_carried_by_few(areas):
        warnings.append(f"A tenth of the states carry more than {_MOST_BY_FEW:.0%} of what the step takes off: take more of them.")
    groups: dict[str, float] = {}
    for one, part in zip(study.states, areas):
        groups[one.group] = groups.get(one.group, 0.0) + float(part) * distance
    reached = study.until if math.isclose(last.distance + distance, study.until, rel_tol=1e-12) else last.distance + distance
    return WornStep(
        last.number + 1, reached, worn.points, edges, depths, last.area + area, new.area_above(worn), T_gamma, T_gamma_with_spin, pmax,
        stiffness.pressure, smoothing, groups, tuple(warnings),
    )  # fmt: skip


def _worn_rows(patch: dict[str, Any]) -> list[dict[str, Any]]:
    """The rows of a patch that wear."""
    return [row for row in patch["solution"].get("wear", {}).get("rows", ()) if row["depths"][0] > 0]


def _loaded_rows(answer: dict[str, Any], weight: float) -> list[LoadedRows]:
    found = []
    for patch in answer.get("patches", ()):
        if not (rows := _worn_rows(patch)):
            continue
        area, dy = patch["solution"]["area"]["contact"], patch["place"]["grid"]["dy"]
        worn = weight * dy * sum(row["depths"][0] for row in rows)
        width = dy * len(rows)
        found.append(LoadedRows(worn, patch["solution"]["forces"]["Fn"] / area, area / width, width))
    return found


def _rate(answer: dict[str, Any], section: Section, edges: Array, study: WearStudy, place: _Place, index: int) -> Array:
    """What a km of this state, or a passage, takes off the cells."""
    state = study.states[index].state
    position = {"y": state.position.y, "roll": state.position.roll, "yaw": state.position.yaw, "z": answer["z"]}
    rate = np.zeros(len(edges) - 1)
    for patch in answer.get("patches", ()):
        if not (rows := _worn_rows(patch)):
            continue
        y, z = np.array([row["y"] for row in rows]), np.array([row["z"] for row in rows])
        depths = np.array([row["depths"][0] for row in rows])
        if study.wears == "wheel":
            x = patch["place"]["reference"]["x"]
            points = rows_on_wheel(y, z, x=x, position=position, origin=place.wheel_origin, radius=place.radius, left=place.left)
            depths = depths * _KM / (2 * np.pi * (place.radius + points[:, 1]))
        else:
            points = rows_on_rail(y, z, origin=place.rail_origin, deviation=(state.rail.y, state.rail.z), left=place.left)
        rate += deposit(edges, section.nearest(points), patch["place"]["grid"]["dy"], depths)
    return rate


def _step(
    rate: Array, size: float, study: WearStudy, left: float, stiffness: Stiffness, modulus: float, warnings: list[str]
) -> tuple[Array, float, float]:
    """The depths of a step, how far it goes, and the wavelength that was smoothed."""
    most = min(left, math.inf if study.distance is None else study.distance)
    is_free = study.smoothing in ("auto", "exponential_step")

    def filtered(depth: float) -> tuple[Array, float]:
        if study.smoothing == "exponential_step":
            return exponential_step(rate, size, depth, stiffness.pressure, modulus), 0.0
        length = stiffness.smoothing(depth) if study.smoothing == "auto" else float(study.smoothing)
        return (smoothed(rate, size, length) if length > 0 else rate), length

    deepest = min(study.depth, stiffness.deepest) if is_free else study.depth
    taken, length = filtered(deepest)
    distance = float(deepest / taken.max())
    if distance > most:  # a step that ends before its depth is reached is smoothed by less
        distance = most
        for _ in range(3):
            taken, length = filtered(distance * float(taken.max()))
    depth = distance * float(taken.max())
    if not is_free and not stiffness.is_stable(depth, length):
        warnings.append(
            f"In a step of {depth:.3g} mm under {stiffness.pressure:.3g} N/mm^2 grooves grow that smoothing by {length:g} mm leaves: "
            "take smaller steps, or smoothing auto."
        )
    return np.asarray(taken * distance), distance, float(length)


def _is_carried_by_few(areas: Array) -> bool:
    few = max(int(_FEW * len(areas)), 1)
    return len(areas) >= 10 and float(np.sort(areas)[-few:].sum()) > _MOST_BY_FEW * float(areas.sum())

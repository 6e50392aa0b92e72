"""Makes one computation with a private daemon, its builder, or another program."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import tempfile
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import numpy as np

from contactd import AnalyticIcs, Client, FemIcs, Grid, InternalError, Material, Paraboloid, RigidBody
from contactd.wheel_rail import Rail60E1, WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

from ..measuring import measuring
from ..section import Measure
from . import groove, solid
from .cases import ACCURACIES, FINEST, Spec
from .persson import Cylinders
from .propagation import Propagation

STEEL = Material(G=82000, nu=0.28)
SIZE = 0.5  # size of strips and elements of a table (mm)
OFFSETS = 60  # of the compared tables
COMPONENTS = [i + j for i in "xyz" for j in "xyz"]
BLOCK = {"edge_block": {"width": 100, "height": 50}}
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
SPEED, RADIUS, FZ = 20e3, 460.0, 80e3


def solver(programs: Path) -> AbstractContextManager[Measure]:
    """Provides a daemon during the `with` block."""
    return measuring(programs, lambda client: Solver(client, programs).measure)


class Solver:
    """Answers requests, one after the other."""

    def __init__(self, client: Client, programs: Path) -> None:
        self._client = client
        self._programs = programs
        self._cylinders = Cylinders(programs)
        self._propagation = Propagation(programs)
        self._finest: dict[str, Any] = {}

    def measure(self, spec: Spec) -> dict[str, Any]:
        """Returns the values for the figures, or {"failure": text} for a solve that did not converge."""
        kinds = {
            "edge": self._edge,
            "throat": self._throat,
            "table": self._table,
            "persson": lambda spec: self._cylinders.measure(spec["half_angle"]),
            "groove": lambda spec: groove.measure(self._client, spec["radius"], spec["body"]),
            "propagation": lambda spec: self._propagation.measure(spec["body"], spec["order"], spec["edges"]),
            "solid": lambda spec: solid.measure(self._programs, {k: v for k, v in spec.items() if k != "kind"}),
        }
        return kinds[spec["kind"]](spec)

    def _edge(self, spec: Spec) -> dict[str, Any]:
        ics = FemIcs(body="longitudinally_uniform", section=BLOCK, accuracy=1e-2) if spec["body"] == "block" else AnalyticIcs()
        solution = self._client.solve(
            grid=Grid(20, 24, 0.25, 0.25, -2.5, spec["distance"] - 6),
            upper=RigidBody(),
            lower=STEEL,
            lower_ics=ics,
            gap=Paraboloid(50, 50),
            Fn=5000,
        )
        if not solution.converged:
            return {"failure": "The contact did not converge."}
        return {"pmax": solution.pmax, "approach": solution.approach}

    def _throat(self, spec: Spec) -> dict[str, Any]:
        setup = WheelRailSetup(rail=Rail60E1(1 / 40), dx=0.4, dy=0.4, conformal=spec["conformal"])
        rolling = WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS)
        state = WheelRailState(position=WheelsetPosition(y=spec["y"]), velocity=rolling, Fz=FZ)
        solution = self._client.wheel_rail(setup, state, fields=[])
        if not solution.converged:
            return {"failure": "The contact did not converge."}
        patch = max(solution.patches, key=lambda patch: patch.solution.pmax)
        track = solution.forces.track
        return {"pmax": patch.solution.pmax, "approach": patch.place.approach, "Fx": track.Fx, "Fy": track.Fy}

    def _table(self, spec: Spec) -> dict[str, Any]:
        """Returns the largest difference of any component to the finest accuracy, over zz of the half-space on itself."""
        name = f"{spec['section']} {spec['nu']}"
        if name not in self._finest:
            self._finest[name] = self._finest_of(spec)
        finest_asked, finest = self._finest[name]
        table = self._built(spec, spec["accuracy"])
        scale = self._client.get_ic(material(spec), Grid.centred(1, 1, SIZE, SIZE), AnalyticIcs())["zz"][0, 0]
        found = max(float(np.abs(table[ij] - finest[ij]).max()) for ij in COMPONENTS) / float(scale)
        assert table.evidence.section is not None
        assert finest.evidence.section is not None
        return {
            "stated": table.evidence.section.error,
            "reciprocity": table.evidence.section.reciprocity_defect / 2,
            "found": found,
            "finest_asked": finest_asked,
            "finest": finest.evidence.section.error,
            "seconds": self._processor_seconds(spec),
            "preset": self._programs.absolute().parent.name,  # a build with assertions takes longer
        }

    def _finest_of(self, spec: Spec) -> tuple[float, Any]:
        """Returns the finest accuracy that is not refused, and its table."""
        try:
            return FINEST, self._built(spec, FINEST)
        except InternalError as error:
            if "was not reached" not in error.message:
                raise
        coarser = min(ACCURACIES)
        return coarser, self._built(spec, coarser)

    def _processor_seconds(self, spec: Spec) -> float:
        """Returns the processor time of a separate builder, including its start and end. Wall-clock time would depend
        on other work."""
        columns = spec["columns"]
        request = {
            "material": {"G": STEEL.G, "nu": spec["nu"]},
            "grid": {"nx": OFFSETS, "ny": columns, "dx": SIZE, "dy": SIZE},
            "ics": {"source": "fem", "body": "longitudinally_uniform", "section": spec["section"], "accuracy": spec["accuracy"]},
        }
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "spec.json")
            file.write_text(json.dumps(request))
            command = [str(self._programs / "contactd-ic"), str(file), "--output", f"{folder}/table.h5"]
            before = _used_by_children()
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=os.environ | ONE_THREAD)
            return _used_by_children() - before

    def _built(self, spec: Spec, accuracy: float) -> Any:
        columns = spec["columns"]
        grid = Grid.centred(OFFSETS, columns, OFFSETS * SIZE, columns * SIZE)
        ics = FemIcs(body="longitudinally_uniform", section=spec["section"], accuracy=accuracy)
        return self._client.get_ic(material(spec), grid, ics)


def _used_by_children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def material(spec: Spec) -> Material:
    return Material(G=STEEL.G, nu=spec["nu"])

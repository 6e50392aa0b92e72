"""Writes a .subs file, and the subsurface results of an .out file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..._version import MARK
from ..case_results import COMPONENTS, LETTERS, StressField
from ..solved_case import SolvedCase
from .numbers import fortran_g, general

__all__ = ["subs_text", "subs_texts"]

_SHORT, _LONG = 8, 14
_ALL = 2  #: The digit A that prints all components.


def subs_texts(solved: SolvedCase) -> Iterator[tuple[str, str]]:
    """Yields a letter (empty for basic contact) and the text of each contact; nothing if the digit A of the points is
    0.
    """
    case = solved.case
    level = case.values.get("SUBS_A", 0) if case.digits["S"] >= 1 else 0
    for index, patch in enumerate(solved.answer.patches if level != 0 else ()):
        letter = LETTERS[index % len(LETTERS)] if case.module == 1 else ""
        if patch.blocks or letter:
            yield letter, subs_text([StressField(block) for block in patch.blocks], level == _ALL)


def subs_text(fields: Sequence[StressField], all_components: bool) -> str:
    """Returns blocks of points, x fastest: positions, displacements, hydrostatic and von Mises stress, and all
    components if requested.
    """
    return "\n".join([line for field in fields for line in _block(field, all_components)] + [""])


def _block(field: StressField, all_components: bool) -> Iterator[str]:
    nz, ny, nx = field.hydrostatic.shape
    columns = _LONG if all_components else _SHORT
    yield f"% nx, ny, nz; {MARK}"
    yield f"{nx:6d}{ny:12d}{nz:12d}      " + fortran_g(0.0) * (columns - 3)
    names = ["X", "Y", "Z", "UX", "UY", "UZ", "SIGHYD", "SIGVM"]
    names += [f"SIG{name}" for name in COMPONENTS] if all_components else []
    yield "%" + "".join(f"{name:>12}" for name in names)
    z, y, x = np.meshgrid(field.z, field.y, field.x, indexing="ij")
    values = [x, y, z, *(field.block[f"U{axis}"] for axis in "XYZ"), field.hydrostatic, field.von_mises]
    values += list(field.stress) if all_components else []
    for row in np.stack([value.ravel() for value in values], axis=1):
        yield "".join(general(float(value), 6, 5) for value in row)

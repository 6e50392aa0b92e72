"""Tables that are too large for one message, fetched by rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ..errors import ProtocolError
from ..values.grid import Array, Grid
from ..values.ics import Ics, table_shape
from ..values.service import Limits
from .call import Answering

__all__ = ["fetch_in_pieces"]

_BYTES = 8
_COMPONENTS = tuple(load + axis for load in "xyz" for axis in "xyz")


def fetch_in_pieces(
    ask: Callable[[dict[str, Any]], Answering[dict[str, Any]]],
    params: dict[str, Any],
    grid: Grid,
    ics: Ics,
    limits: Limits,
) -> Answering[dict[str, Any]]:
    """The result of ic.get for a whole table, put together from parts of it that fit the daemon's `limits`."""
    shape = table_shape(grid, ics)
    rows = int(np.prod(shape[:-1]))
    table: Array = np.empty((len(_COMPONENTS), rows, grid.nx))
    whole: dict[str, Any] = {}
    for components, first, count in _parts(grid.nx, rows, min(limits.max_frame_bytes, limits.max_message_bytes // 2)):
        names = [_COMPONENTS[number] for number in components]
        result = yield from ask({**params, "components": names, "rows": {"first": first, "count": count}})
        part = result.pop("table", None)
        if not isinstance(part, np.ndarray) or part.shape != (len(names), count, grid.nx):
            raise ProtocolError("A part of the table has another shape than was asked for.")
        table[components, first : first + count] = part
        whole = whole or result
        if result.get("key") != whole.get("key"):
            raise ProtocolError("The parts of the table belong to different tables.")
    table.flags.writeable = False
    return {**whole, "table": table.reshape(3, 3, *shape)}


def _parts(nx: int, ny: int, most_bytes: int) -> Iterator[tuple[list[int], int, int]]:
    """Numbers of components, the first row and the number of rows, as large as they may be."""
    numbers = max(1, most_bytes // _BYTES)
    together = min(len(_COMPONENTS), max(1, numbers // nx))
    rows = max(1, numbers // (nx * together))
    for begin in range(0, len(_COMPONENTS), together):
        components = list(range(begin, min(begin + together, len(_COMPONENTS))))
        for first in range(0, ny, rows):
            yield components, first, min(rows, ny - first)

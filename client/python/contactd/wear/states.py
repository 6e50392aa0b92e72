"""Describes states of a collective: position and motion of a wheelset, and the share of the distance or of the
passages."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from ..calls.answer_warnings import give
from ..errors import invalid
from ..files.number_text import table_of
from ..files.whole import read_whole
from ..refusals import did_you_mean
from ..values.generated.wheel_rail.state import WheelRailState

__all__ = ["WeightedState", "mirrored", "read_states", "states_of_columns"]

OnProgress = Callable[[float], None]

_ROWS_OF_REPORT = 2000
_LONGEST_NAME = 60  #: Largest length of a column's name in a message.
_MOST_BYTES = 1 << 30  #: Largest size of a file of states.
_MICROMETRES = (5e-4, 0.015)  #: largest position.y (mm) of states that are probably in m, as for a single solve
_ODD = {"y", "roll", "yaw", "y_velocity", "roll_velocity", "yaw_velocity", "Fy"}
_OWN = ("weight", "distance", "group", "mu")


@dataclass(frozen=True)
class WeightedState:
    """A state with its share.

    Attributes:
        state: Position and motion of the wheelset.
        weight: Share of the distance of a wheel, or of the passages over a rail, relative to the sum of all weights.
        group: Its group, such as a class of curves; results are reported by groups.
        mu: Friction coefficient of the state; None: that of the set-up.
    """

    state: WheelRailState
    weight: float
    group: str = ""
    mu: float | None = None


def read_states(path: str | os.PathLike[str], on_progress: OnProgress | None = None) -> list[WeightedState]:
    """Reads the states in a file with a row per state. By its extension: CSV with names in the first line, HDF5 with a
    dataset per column, or Parquet (with pyarrow). In CSV, text after #, % or ! is a comment. If columns are separated
    by semicolons or tabs, a comma is a decimal comma.

    Columns are paths of a state, such as ``position.y``, ``velocity.yaw`` or ``Fz``; either ``weight`` or ``distance``,
    which is required; ``group`` and ``mu``. `on_progress` receives the fraction read. Raises InvalidArgument naming the
    error, and OSError for files that cannot be read.
    """
    name = os.fspath(path).lower()
    if name.endswith((".h5", ".hdf5")):
        return states_of_columns(_hdf5_columns(path), on_progress)
    if name.endswith(".parquet"):
        return states_of_columns(_parquet_columns(path), on_progress)
    content = read_whole(path, _MOST_BYTES)
    try:
        if on_progress is not None:
            on_progress(0.0)
        head, rows = table_of(content.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise invalid("states", "are not text in UTF-8; give a CSV file, or one of HDF5 (.h5) or Parquet (.parquet)") from None
    except ValueError as error:
        raise invalid("states", f"cannot be read: {error}") from None
    if not head:
        raise invalid("states", "are empty; the first line must name the columns, such as position.y, Fz, weight")
    return states_of_columns({column: [cells[i] for _, cells in rows] for i, column in enumerate(head)}, on_progress)


def states_of_columns(columns: Mapping[str, Iterable[Any]], on_progress: OnProgress | None = None) -> list[WeightedState]:
    """Returns the states of columns by their names, like read_states. Raises InvalidArgument naming the column."""
    table = {name: list(values) for name, values in columns.items()}
    if len({len(values) for values in table.values()}) > 1:
        raise invalid("states", f"have columns of different lengths: {', '.join(f'{name} {len(values)}' for name, values in table.items())}")
    weights = [name for name in ("weight", "distance") if name in table]
    if len(weights) != 1:
        which = "both weight and distance" if weights else "neither weight nor distance"
        raise invalid("states", f"have {which}; give one of these columns with the share of each state")
    count = len(table[weights[0]])
    numbers = {name: _numbers(values, name) for name, values in table.items() if name not in ("group", "mu")}
    if (least := min(numbers[weights[0]], default=0.0)) < 0:
        raise invalid(f"states[{numbers[weights[0]].index(least)}].{weights[0]}", f"is {least:g}; it must be at least 0")
    state_of = _maker({name: values for name, values in numbers.items() if name not in _OWN} if count else {})
    mu, group = table.get("mu"), table.get("group")
    states = []
    for row in range(count):
        if on_progress is not None and row % _ROWS_OF_REPORT == 0:
            on_progress(row / count)
        own = None if mu is None or mu[row] in ("", None) else _number(mu[row], f"states[{row}].mu")
        states.append(WeightedState(state_of(row), numbers[weights[0]][row], "" if group is None else str(group[row]), own))
    if not sum(one.weight for one in states) > 0:
        raise invalid("states", f"all have a {weights[0]} of 0; give at least one of them a positive {weights[0]}")
    give(_in_metres(numbers.get("position.y", [])))
    return states


def _in_metres(positions: Sequence[float]) -> Iterator[str]:
    """Returns a sentence about a column of lateral positions that are micrometres throughout."""
    largest = max(map(abs, positions), default=0.0)
    if _MICROMETRES[0] <= largest <= _MICROMETRES[1]:
        yield (
            f"states: position.y is at most {largest:g} mm, micrometres from the track centre, in all of them. Give lengths in mm, not in m. "
            f"If it is in m, it is up to {1000 * largest:g} mm."
        )


def mirrored(one: WeightedState) -> WeightedState:
    """Returns the state of a wheel on the right rail that is the mirror image of the left wheel in the given state."""
    return replace(one, state=_mirrored(one.state))


def _mirrored(value: Any) -> Any:
    """Changes the signs of lateral quantities, and of rotations about the longitudinal and vertical axes."""
    changed: dict[str, Any] = {}
    for field in fields(value):
        part = getattr(value, field.name)
        if hasattr(part, "__dataclass_fields__"):
            changed[field.name] = _mirrored(part)
        elif field.name in _ODD and part:
            changed[field.name] = -part
    return replace(value, **changed)


def _numbers(values: list[Any], name: str) -> list[float]:
    """Returns the numbers of a column. Raises InvalidArgument naming the row."""
    try:
        found = [float(value) for value in values]
    except (TypeError, ValueError):
        found = [math.nan]
    if not all(map(math.isfinite, found)):
        return [_number(value, f"states[{row}].{name}") for row, value in enumerate(values)]
    return found


def _maker(columns: Mapping[str, list[float]]) -> Callable[[int], WheelRailState]:
    """Returns a function that creates the states of rows with these columns. Raises InvalidArgument naming an invalid
    column.
    """
    tree: dict[str, Any] = {}
    for name, values in columns.items():
        at, path = tree, name.split(".")
        _check(WheelRailState(), name, path)
        for part in path[:-1]:
            at = at.setdefault(part, {})
        at[path[-1]] = values
    return _maker_of(WheelRailState(), tree)


def _maker_of(plain: Any, tree: Mapping[str, Any]) -> Callable[[int], Any]:
    kind, others = type(plain), {field.name: getattr(plain, field.name) for field in fields(plain) if field.name not in tree}
    columns = {name: part for name, part in tree.items() if not isinstance(part, dict)}
    parts = {name: _maker_of(getattr(plain, name), part) for name, part in tree.items() if isinstance(part, dict)}

    def made(row: int) -> Any:
        given = {name: values[row] for name, values in columns.items()}
        return kind(**others, **given, **{name: make(row) for name, make in parts.items()})

    return made


def _check(value: Any, name: str, path: list[str]) -> None:
    known = {field.name for field in fields(value)}
    if path[0] not in known:
        others = f"{', '.join(sorted(known))}.{did_you_mean(path[0][:_LONGEST_NAME], known)}"
        raise invalid("states", f"have a column {name:.60}; a state has no {path[0]:.60} there, but {others}")
    part = getattr(value, path[0])
    is_object = hasattr(part, "__dataclass_fields__")
    if is_object != (len(path) > 1):
        raise invalid("states", f"have a column {name:.60}, which is not a number of a state")
    if is_object:
        _check(part, name, path[1:])


def _number(value: Any, field: str) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise invalid(field, f"is {value!r:.60}; it must be a number")
    return number


def _parquet_columns(path: str | os.PathLike[str]) -> dict[str, list[Any]]:
    try:
        from pyarrow import parquet  # type: ignore[import-not-found]
    except ImportError:
        raise invalid("states", f"are in {os.fspath(path)}, but reading Parquet requires pyarrow: pip install pyarrow, or write CSV") from None
    import pyarrow

    try:
        table = parquet.read_table(os.fspath(path))
    except pyarrow.ArrowException as error:
        raise invalid("states", f"are not a Parquet file: {error}") from None
    return {str(name): table.column(name).to_pylist() for name in table.column_names}


def _hdf5_columns(path: str | os.PathLike[str]) -> dict[str, list[Any]]:
    import h5py

    with open(path, "rb"):  # Its message is clearer than that of h5py.
        pass
    try:
        with h5py.File(path, "r") as file:
            if wrong := next((name for name in file if getattr(file[name], "ndim", 0) != 1), None):
                raise invalid("states", f"have {wrong}, which is not a column; a column is a dataset with one number or word for each state")
            columns = {name: file[name][()] for name in file}
    except OSError as error:
        raise invalid("states", f"are not a readable HDF5 file: {error}") from None
    return {name: [v.decode(errors="replace") if isinstance(v, bytes) else v for v in values.tolist()] for name, values in columns.items()}

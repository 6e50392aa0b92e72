"""Tables of influence coefficients."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Literal

import numpy as np

from ..errors import InvalidArgument, ProtocolError
from ..values.answers import read
from ..values.arrays import Array
from ..values.contact_params import table_params, table_shape
from ..values.generated.grid import Grid
from ..values.generated.ics import Ics
from ..values.generated.materials import LayeredBody, Material
from ..values.generated.records import ImportedIc, QuarantinedIc, StoredIc
from ..values.generated.service import Limits
from ..values.params import params_of
from ..values.tables import IcTable
from .call import Answering, asks
from .caller import Caller, ProgressCallback, check_shapes

__all__ = ["TableCalls", "fetch_in_pieces"]

_BYTES = 8
_COMPONENTS = tuple(load + axis for load in "xyz" for axis in "xyz")


class TableCalls(Caller):
    """Calls the methods ic.* of the daemon."""

    @asks
    def get_ic(
        self,
        material: Material | LayeredBody,
        grid: Grid,
        ics: Ics,
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[IcTable]:
        """Returns the influence coefficients of one body. If no cache has them, the daemon builds them, which may take
        minutes.

        A timeout ends the wait, not the build. A table that is too large for one message is returned in several, each
        with the same timeout.
        """
        params = table_params(material, grid, ics)

        def ask(params: dict[str, Any]) -> Answering[dict[str, Any]]:
            return (
                yield from self.asked(
                    "ic.get", params, timeout=timeout, on_progress=on_progress, progress=progress
                )
            )

        try:
            result = yield from ask(params)
        except InvalidArgument as error:
            if error.reason != "ANSWER_TOO_LARGE":
                raise
            limits = (yield from self.info_asked(timeout)).limits
            result = yield from fetch_in_pieces(ask, params, grid, ics, limits)
        result["array"] = result.pop("table", None)
        table = read(IcTable, result)
        check_shapes(table, ["array"], (3, 3, *table_shape(grid, ics)))
        return table

    @asks
    def export_ic(
        self,
        material: Material | LayeredBody,
        grid: Grid,
        ics: Ics,
        format: Literal["hdf5", "contact"] = "hdf5",
        *,
        lower: Material | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[bytes]:
        """Returns the table of get_ic as the content of a file. The format "hdf5" is described in docs/ic-tables.md.
        "contact" is the text format of the CONTACT program for a pair of bodies; `lower` is the second body (None:
        equal to the first).
        """
        params = {**table_params(material, grid, ics), "format": format}
        if lower is not None:
            params["lower"] = params_of(lower)
        result = yield from self.asked("ic.export", params, timeout=timeout, on_progress=on_progress, progress=progress)
        content = result.get("file", result.get("text"))
        if isinstance(content, str):
            return content.encode()
        if not isinstance(content, np.ndarray) or content.dtype != np.uint8:
            raise ProtocolError("The answer to ic.export lacks its file.")
        return content.tobytes()

    @asks
    def import_ic(self, file: bytes, *, timeout: float | None = None) -> Answering[ImportedIc]:
        """Imports a table into the daemon's store from the content of a file: of export_ic ("hdf5"), or of another
        store.

        The file is read in this process (needs h5py), and its content is sent to the daemon. Tables that the daemon
        already has are kept. Only your own requests use the table, unless store.share_imported_tables is set. Answers
        that use it contain a warning that it was imported. Tables of longitudinally uniform bodies then apply to any
        length and number of elements along x. Raises TableFileError for other or damaged files. Raises InvalidArgument
        for a table with a closed form, a table whose error exceeds the stated one, or a table that no elastic body can
        have.
        """
        if not isinstance(file, bytes | bytearray | memoryview):
            raise TypeError(f"file is {file!r}; it must be the bytes of a file, such as Path(name).read_bytes()")
        from ..files.ic_files import import_params

        params = import_params(bytes(file))
        return read(ImportedIc, (yield from self.asked("ic.import", params, timeout=timeout)))

    @asks
    def _page_of_stored_ics(
        self, after: str | None, evidence: bool, timeout: float | None
    ) -> Answering[tuple[list[StoredIc], str | None]]:
        """Returns up to a thousand tables of the store after `after`, and the start of the next page; None if there are
        no more.
        """
        params: dict[str, Any] = {} if after is None else {"after": after}
        if evidence:
            params |= {"evidence": True, "limit": 100}
        result = yield from self.asked("ic.list", params, timeout=timeout)
        tables = result.get("tables")
        if not isinstance(tables, list):
            raise ProtocolError("The answer to ic.list lacks its tables.")
        return [read(StoredIc, table, f"result.tables[{i}]") for i, table in enumerate(tables)], result.get("next")

    @asks
    def quarantined_ics(self, *, timeout: float | None = None) -> Answering[tuple[QuarantinedIc, ...]]:
        """Returns the tables whose builds failed too often. Requests for them raise FailedPrecondition with
        .retry_delay (s).
        """
        entries = (yield from self.asked("ic.list", {"limit": 1}, timeout=timeout)).get("quarantined")
        if not isinstance(entries, list):
            raise ProtocolError("The answer to ic.list lacks its builds in quarantine.")
        return tuple(read(QuarantinedIc, entry, f"result.quarantined[{i}]") for i, entry in enumerate(entries))

    @asks
    def delete_ic(self, key: str, *, timeout: float | None = None) -> Answering[int]:
        """Removes the tables of a key from the daemon's store and ends its quarantine. Returns the number of removed
        tables.

        Raises NotFound if there is neither.
        """
        removed = (yield from self.asked("ic.delete", {"key": key}, timeout=timeout)).get("tables")
        if not isinstance(removed, int):
            raise ProtocolError("The answer to ic.delete lacks the number of tables.")
        return removed


def fetch_in_pieces(
    ask: Callable[[dict[str, Any]], Answering[dict[str, Any]]],
    params: dict[str, Any],
    grid: Grid,
    ics: Ics,
    limits: Limits,
) -> Answering[dict[str, Any]]:
    """Returns the result of ic.get for a whole table, assembled from parts that fit the daemon's `limits`."""
    shape = table_shape(grid, ics)
    rows = int(np.prod(shape[:-1]))
    table: Array = np.empty((len(_COMPONENTS), rows, grid.nx))
    whole: dict[str, Any] = {}
    for components, first, count in _parts(grid.nx, rows, min(limits.max_frame_bytes, limits.max_message_bytes // 2)):
        names = [_COMPONENTS[number] for number in components]
        result = yield from ask({**params, "components": names, "rows": {"first": first, "count": count}})
        part = result.pop("table", None)
        if not isinstance(part, np.ndarray) or part.shape != (len(names), count, grid.nx):
            raise ProtocolError("A part of the table does not have the requested shape.")
        table[components, first : first + count] = part
        whole = whole or result
        if result.get("key") != whole.get("key"):
            raise ProtocolError("The parts of the table belong to different tables.")
    table.flags.writeable = False
    return {**whole, "table": table.reshape(3, 3, *shape)}


def _parts(nx: int, ny: int, most_bytes: int) -> Iterator[tuple[list[int], int, int]]:
    """Yields component numbers, first row and number of rows of parts that are as large as possible."""
    numbers = max(1, most_bytes // _BYTES)
    together = min(len(_COMPONENTS), max(1, numbers // nx))
    rows = max(1, numbers // (nx * together))
    for begin in range(0, len(_COMPONENTS), together):
        components = list(range(begin, min(begin + together, len(_COMPONENTS))))
        for first in range(0, ny, rows):
            yield components, first, min(rows, ny - first)

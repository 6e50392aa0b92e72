"""Writes table files for other programs, shows them, and imports them into the folder of a store."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import click
import numpy as np

from contactd import AnalyticIcs, Client, FemIcs, Grid, IcTable, Material, TableIcs, load_table, save_table
from contactd.files.ic_contents import file_of
from contactd.files.ic_files import imported_contents, stored_extent
from contactd.files.whole import MOST_BYTES, read_whole, write_whole
from contactd.values.answers import read
from contactd.values.tables import IcSpec

from .asking import ask
from .files import check_own, writable
from .output import facts, size

__all__ = ["check_suffix", "import_files", "send_files", "shown_file", "write_export"]

_STORED = re.compile(r"([0-9a-f]{64})\.(\d+)x(\d+)\.h5")


def check_suffix(output: str) -> None:
    """Checks the extension before a build. Raises click.UsageError."""
    if not output.endswith((".h5", ".npz", ".txt")):
        raise click.UsageError(f"--output {output}: the name must end in .h5, .npz or .txt.")
    writable("--output", output)


def write_export(client: Client, params: dict[str, Any], output: str) -> int:
    """Writes the file, which is never incomplete, and returns its size in bytes."""
    if output.endswith(".npz"):
        # Builds the table first, with a progress bar.
        given = ask(client, "ic.get", {**params, "components": ["zz"], "rows": {"first": 0, "count": 1}}, "building")
        spec = read(IcSpec, given["spec"], "spec")
        save_table(output, client.get_ic(spec.material, spec.grid, _as_asked(params, spec)))
        return os.path.getsize(output)
    given = ask(client, "ic.export", {**params, "format": "hdf5" if output.endswith(".h5") else "contact"}, "building")
    content = given["text"].encode() if "text" in given else np.asarray(given["file"], dtype=np.uint8).tobytes()
    write_whole(output, lambda file: file.write(content))
    return len(content)


def _as_asked(params: dict[str, Any], spec: IcSpec) -> AnalyticIcs | FemIcs:
    """Returns the coefficients as requested: the answer includes defaults, which may exclude each other."""
    fields = {name: value for name, value in params["ics"].items() if name not in ("source", "layers", "base")}
    if isinstance(spec.ics, FemIcs):
        return FemIcs(**fields)
    return AnalyticIcs(load_shape=fields.get("load_shape"))


def shown_file(path: str) -> tuple[dict[str, Any], Any]:
    """Returns JSON and text. Raises click.UsageError or TableFileError."""
    try:
        table = load_table(path)
    except OSError as error:
        raise click.UsageError(f"{path} cannot be read: {error.strerror or error}.") from None
    if isinstance(table, TableIcs):
        ny, nx = table.array.shape[2:]
        given = {"file": path, "of": "pair", "nx": nx, "ny": ny, "dx": table.dx, "dy": table.dy, "G": table.G}
        rows: list[tuple[str, Any]] = [("of", "a pair of bodies"), ("modulus G", table.G)]
        rows += [("offsets", f"{nx} x {ny} of {table.dx:g} x {table.dy:g} mm")]
        return given, facts(path, [*rows, ("in memory", size(table.array.nbytes))])
    return {"file": path, "of": "body", "spec": table.spec, "evidence": table.evidence}, _shown(path, table)


def _shown(path: str, table: IcTable) -> Any:
    grid, evidence, body = table.spec.grid, table.evidence, table.spec.material
    is_unit = (grid.dx, getattr(body, "G", None)) == (1.0, 1.0)
    errors = evidence.errors
    return facts(
        path,
        [
            ("of", f"a body of G = {body.G:g} N/mm^2, nu = {body.nu:g}" if isinstance(body, Material) else "layers"),
            ("offsets", _extent(grid) + (", as in a store" if is_unit else "")),
            ("source", "finite elements" if evidence.source == "fem" else "closed form"),
            ("elements", evidence.elements or None),
            ("unknowns", evidence.dofs or None),
            ("made by", evidence.version),
            ("error of zz", None if errors is None else f"{errors.zz.origin:.2g} at the origin, up to {errors.zz.largest:.2g}"),
            ("modelling error", None if evidence.modelling_error is None else f"{evidence.modelling_error:.2g}"),
            ("in memory", size(table.array.nbytes)),
            *(("warning", warning) for warning in evidence.warnings),
        ],
    )


def _extent(grid: Grid) -> str:
    return f"{grid.nx} x {grid.ny} of {grid.dx:g} x {grid.dy:g} mm"


def send_files(client: Client, files: list[str]) -> list[dict[str, Any]]:
    """Imports each file into the daemon. Raises click.UsageError if one cannot be read, TableFileError if it is not a
    table, and StatusError if the daemon refuses it.
    """
    done = []
    for file in files:
        try:
            content = read_whole(file, MOST_BYTES)
        except OSError as error:
            raise click.UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
        imported = client.import_ic(content)
        grid = imported.spec.grid
        done.append({"key": imported.ics.key, "nx": grid.nx, "ny": grid.ny, "new": imported.new})
    return done


def import_files(files: list[str], store: str) -> list[dict[str, Any]]:
    """Checks each file, and writes its contents to a new file, which is never incomplete. Raises click.UsageError or
    TableFileError.
    """
    folder = Path(store)
    if not folder.is_dir():
        raise click.UsageError(f"--store {store} is not a folder.")
    checked = [_checked(Path(file)) for file in files]
    done = []
    for file, key, nx, ny in checked:
        target = folder / file.name
        is_new = not target.exists()
        if is_new:
            check_own("--store", target)
            content = file_of(imported_contents(file))
            write_whole(target, lambda opened, content=content: opened.write(content))
        done.append({"key": key, "nx": nx, "ny": ny, "new": is_new})
    return done


def _checked(file: Path) -> tuple[Path, str, int, int]:
    """Returns the file with the key and extent of its name after checking digest and extent."""
    matched = _STORED.fullmatch(file.name)
    if matched is None:
        raise click.UsageError(
            f"{file} is not a file of a store, which has the name <key>.<nx>x<ny>.h5. Without --store the daemon also imports files of ic " "export."
        )
    if not file.exists():
        raise click.UsageError(f"{file} does not exist.")
    key, nx, ny = matched[1], int(matched[2]), int(matched[3])
    if (found := stored_extent(file)) != (ny, nx):
        raise click.UsageError(f"{file} contains {found[1]} x {found[0]} offsets, but its name states {nx} x {ny}.")
    return file, key, nx, ny

"""Implements ic: tables of influence coefficients, in the daemon's store and in files."""

from __future__ import annotations

from typing import Annotated, Any

import click
import typer
from rich.console import RenderableType

from contactd import Client, NotFound, QuarantinedIc, StoredIc

from ..asking import ask
from ..codes import Code, Ended
from ..common import Command, Group, connected, setting
from ..output import counted, emit, facts, listing, note, size, span
from ..table_files import check_suffix, import_files, send_files, shown_file, write_export
from ..table_spec import (
    DX,
    DY,
    NU,
    NX,
    NY,
    Accuracy,
    E,
    G,
    Set,
    Spec,
    as_given,
    offsets_of,
    table_params,
)

__all__ = ["add_to"]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Tables of influence coefficients.", rich_markup_mode=None)
    for command in (build, show, export, delete):
        family.command(cls=Command)(command)
    family.command("list", cls=Command)(list_tables)
    family.command("import", cls=Command)(import_tables)
    app.add_typer(family, name="ic")


def build(
    file: Spec = None, sets: Set = None, G: G = None, E: E = None, nu: NU = None,
    nx: NX = None, ny: NY = None, dx: DX = None, dy: DY = None, accuracy: Accuracy = None,
) -> None:  # fmt: skip
    """Build a table in the daemon, unless it exists.

    Ctrl-C ends the build, unless other clients wait for it.

    FILE contains the parameters of ic.get: material, grid, ics. Without a file, use the options.
    """
    params = table_params(file, as_given(G=G, E=E, nu=nu, nx=nx, ny=ny, dx=dx, dy=dy, accuracy=accuracy), sets)
    count = offsets_of(params)
    if count:
        note(f"{count} offsets: the table needs {size(72 * count)} of memory, and the same in the store.")
    # Only a row of one component is sent, so that a table of any size can be built.
    part = {**params, "components": ["zz"], "rows": {"first": 0, "count": 1}}
    with connected() as client:
        inputs = ask(client, "ic.get", part, "building")
    del inputs["table"], inputs["rows"], inputs["components"]
    emit(setting().json, inputs, _shown(inputs))


def _shown(inputs: dict[str, Any]) -> RenderableType:
    evidence, grid = inputs["evidence"], inputs["spec"]["grid"]
    seconds = evidence.get("seconds", {}).get("total")
    errors = evidence.get("errors") or {}
    kind = "estimated" if evidence.get("errors_estimated") else "against the closed form"
    worst = max((errors[name]["largest"] for name in ("xx", "yy", "zz") if name in errors), default=None)
    return facts(
        f"Table {inputs['key'][:16]}",
        [
            ("key", inputs["key"]),
            ("came from", {"closed_form": "closed form"}.get(inputs["origin"], inputs["origin"])),
            ("offsets", f"{grid['nx']} x {grid['ny']} of {grid['dx']:g} x {grid['dy']:g} mm"),
            ("elements", evidence.get("elements")),
            ("unknowns", evidence.get("dofs")),
            ("solver", evidence.get("solver")),
            ("took", span(seconds) if seconds else None),
            ("modelling error", f"{modelling:.2g}" if (modelling := evidence.get("modelling_error")) is not None else None),
            ("largest error", None if worst is None else f"{worst:.2g} of xx, yy and zz, {kind}"),
        ],
    )


def list_tables() -> None:
    """List the tables of the store, and builds in quarantine."""
    with connected() as client:
        tables, quarantined = list(client.stored_ics()), client.quarantined_ics()
    total = sum(table.bytes for table in tables)
    shown: list[RenderableType] = ["the store is empty"]
    if tables:
        rows = [(table.key[:16], f"{table.nx} x {table.ny}", size(table.bytes)) for table in tables]
        shown = [listing(None, ["key", "offsets", "size"], rows), "", f"{counted(len(tables), 'table')}, {size(total)}"]
    if quarantined:
        shown += ["", _shown_quarantine(quarantined)]
    emit(setting().json, {"tables": tables, "quarantined": quarantined, "bytes": total}, *shown)


def _shown_quarantine(quarantined: tuple[QuarantinedIc, ...]) -> RenderableType:
    rows = [(entry.key[:16], f"{entry.nx} x {entry.ny}", entry.failures, span(entry.seconds), entry.message) for entry in quarantined]
    return listing("In quarantine", ["key", "offsets", "failures", "again in", "the last one"], rows)


def show(
    table: Annotated[str, typer.Argument(metavar="KEY|FILE", help="A key of ic list, its beginning, or a .h5, .npz or .txt file.")],
) -> None:
    """Show the contents of a file, or the store's table of a key."""
    if table.endswith((".h5", ".npz", ".txt")):
        inputs, shown = shown_file(table)
        emit(setting().json, inputs, shown)
        return
    with connected() as client:
        key = _whole_key(client, table)
        stored = [entry for entry in client.stored_ics() if entry.key == key]
        quarantined = [entry for entry in client.quarantined_ics() if entry.key == key]
    rows: list[tuple[str, Any]] = [("key", key)]
    rows += [("stored", f"{entry.nx} x {entry.ny} offsets, {size(entry.bytes)}") for entry in stored]
    rows += [("in quarantine", f"{entry.failures} failures, the last: {entry.message}") for entry in quarantined]
    emit(setting().json, {"key": key, "tables": stored, "quarantined": quarantined}, facts(f"Table {key[:16]}", rows))


def export(
    output: Annotated[str, typer.Option("--output", "-o", help="FILE.h5, FILE.npz, or FILE.txt for the CONTACT program.")],
    file: Spec = None, sets: Set = None, G: G = None, E: E = None, nu: NU = None,
    nx: NX = None, ny: NY = None, dx: DX = None, dy: DY = None, accuracy: Accuracy = None,
) -> None:  # fmt: skip
    """Write a table to a file.

    The daemon builds it, unless it exists.
    """
    check_suffix(output)
    params = table_params(file, as_given(G=G, E=E, nu=nu, nx=nx, ny=ny, dx=dx, dy=dy, accuracy=accuracy), sets)
    with connected() as client:
        written = write_export(client, params, output)
    emit(setting().json, {"file": output, "bytes": written}, f"{output}: {size(written)}")


def import_tables(
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="Files from ic export (.h5), or of another store.")],
    store: Annotated[str | None, typer.Option("--store", help="Folder of a store to which files of another store are copied, without a daemon.")] = None,
) -> None:
    """Import tables from files into the daemon's store, or into the folder of a store.

    The files are checked first. Daemons with this store find the tables immediately.
    """
    if store is not None:
        done = import_files(files, store)
    else:
        with connected() as client:
            done = send_files(client, files)
    rows = [(entry["key"][:16], f"{entry['nx']} x {entry['ny']}", "new" if entry["new"] else "was there") for entry in done]
    emit(setting().json, {"tables": done}, listing(None, ["key", "offsets", "in the store"], rows))


def delete(
    keys: Annotated[list[str], typer.Argument(metavar="KEY...", help="Keys of ic list, or their beginnings.")],
) -> None:
    """Remove tables from the store, and end their quarantine."""
    removed, missing = [], []
    with connected() as client:
        for given in keys:
            try:
                key = _whole_key(client, given)
                removed.append({"key": key, "tables": client.delete_ic(key)})
            except (NotFound, Ended) as error:
                note(f"contactctl: {error}")
                missing.append(given)
    count = sum(int(entry["tables"]) for entry in removed)  # type: ignore[call-overload]
    emit(setting().json, {"deleted": removed}, f"{counted(count, 'table')} deleted")
    if missing:
        raise typer.Exit(Code.REFUSED)


def _whole_key(client: Client, beginning: str) -> str:
    """Returns the key with this beginning. Raises Ended if there is none, click.UsageError if there are several."""
    if not beginning:
        raise click.UsageError("A key is empty; give at least its beginning from ic list.")
    entries: list[StoredIc | QuarantinedIc] = [*client.stored_ics(), *client.quarantined_ics()]
    found = sorted({entry.key for entry in entries if entry.key.startswith(beginning)})
    if not found:
        raise Ended(Code.REFUSED, f"No table and no failed build has a key that begins with {beginning!r}; see ic list.")
    if len(found) > 1:
        raise click.UsageError(f"{len(found)} keys begin with {beginning!r}; give more characters.")
    return found[0]

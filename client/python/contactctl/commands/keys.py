"""Implements keys, which creates pairs of CURVE keys for encrypted connections (docs/security.md)."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import click
import typer
import zmq
import zmq.auth

from contactd.files.whole import read_whole

from ..common import Command, Group, setting
from ..output import emit, facts

__all__ = ["add_to"]

_MOST_BYTES = 1 << 16  #: Largest size of a key file.


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Keys for encrypted connections.", rich_markup_mode=None)
    family.command(cls=Command)(new)
    family.command(cls=Command)(show)
    app.add_typer(family, name="keys")


def new(
    name: Annotated[str, typer.Argument(help="Owner of the keys: a user, or the daemon.")],
    folder: Annotated[Path, typer.Option("--to", help="Folder for NAME.key and NAME.key_secret.")] = Path("."),
) -> None:
    """Create a pair of keys. Existing files are never overwritten.

    NAME.key is public. Only NAME may read NAME.key_secret.
    """
    if not name or "/" in name or name.startswith("."):
        raise click.UsageError(f"{name!r} cannot be the name of a file; use letters and digits, such as alice.")
    folder.mkdir(parents=True, exist_ok=True)
    public_file, secret_file = folder / f"{name}.key", folder / f"{name}.key_secret"
    for file in (public_file, secret_file):
        if file.exists():
            raise click.UsageError(f"{file} exists, and keys are never overwritten.")
    public, secret = (key.decode() for key in zmq.curve_keypair())
    curve = f'curve\n    public-key = "{public}"\n'
    _write(secret_file, f'# Secret key of {name}: for {name} alone.\n{curve}    secret-key = "{secret}"\n', 0o600)
    _write(public_file, f"# Public key of {name}: for the others.\n{curve}", 0o644)
    given = {"public": str(public_file), "secret": str(secret_file), "public_key": public}
    rows = [("public key, for the others", str(public_file)), (f"secret key, for {name} alone", str(secret_file))]
    emit(setting().json, given, facts(f"Keys of {name}", rows))


def show(file: Annotated[Path, typer.Argument(help="NAME.key or NAME.key_secret.")]) -> None:
    """Show the public key in a file.

    Also reports whether the file contains a secret key, which is never shown.
    """
    try:
        read_whole(file, _MOST_BYTES)  # does not wait for a pipe
        public, secret = zmq.auth.load_certificate(file)
    except OSError as error:
        raise click.UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
    except ValueError:
        raise click.UsageError(f'{file} has no line public-key = "...": it is not a key file.') from None
    is_private = not file.stat().st_mode & 0o077
    given = {"public_key": public.decode(), "secret": secret is not None, "private": is_private}
    secrecy = "none" if secret is None else ("for its owner only" if is_private else f"OTHERS CAN READ IT: chmod 600 {file}")
    emit(setting().json, given, facts(str(file), [("public key", public.decode()), ("secret key", secrecy)]))


def _write(file: Path, text: str, mode: int) -> None:
    with os.fdopen(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "w") as opened:
        opened.write(text)

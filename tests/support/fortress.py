"""Provides a daemon that encrypts, and keys for its users."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path
from typing import Any

from contactd import Client

from .daemons import BIN, Daemons, eventually


def keygen(folder: Path, name: str) -> tuple[Path, Path]:
    """Calls contactd keygen; returns the secret and the public file."""
    subprocess.run([BIN / "contactd", "keygen", name, "--folder", folder], check=True, capture_output=True, timeout=30)
    return folder / f"{name}.key_secret", folder / f"{name}.key"


class Fortress:
    """Starts the daemon and creates its user alice; `config` is that of Daemons.start."""

    def __init__(self, daemons: Daemons, folder: Path, **config: Any) -> None:
        self.folder = folder
        self.secret, self.public = keygen(folder / "server", "server")
        self.allowed = folder / "allowed"
        self.alice = self.make_user("alice")
        self.allow("alice")
        curve = {"secret_key_file": str(self.secret), "allowed_keys": str(self.allowed)}
        security = {"curve": curve, **config.pop("security", {})}
        self.daemon = daemons.start(security=security, **{"endpoint": "tcp://127.0.0.1:*", **config})

    def make_user(self, name: str) -> Path:
        return keygen(self.folder / "users", name)[0]

    def allow(self, name: str) -> None:
        self.allowed.mkdir(exist_ok=True)
        public = (self.folder / "users" / f"{name}.key").read_text()
        (self.allowed / f"{name}.key").write_text(public)

    def client(self, own_key: Path | None = None, server_key: Path | None = None, **options: Any) -> Client:
        return self.daemon.client(server_key=server_key or self.public, own_key=own_key or self.alice, **options)

    def reload(self, sign: str = "keys are allowed") -> None:
        """Sends SIGHUP, and waits until the log reports that the keys were read."""
        before = self.daemon.log.count(sign)
        self.daemon.process.send_signal(signal.SIGHUP)
        eventually(lambda: self.daemon.log.count(sign) > before)

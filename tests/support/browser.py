"""Drives a headless Chromium through a pipe by its DevTools protocol: no port, and only Debian's package."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
from pathlib import Path
from types import TracebackType
from typing import Any

from .daemons import eventually

PROGRAM = shutil.which("chromium-headless-shell") or shutil.which("chromium")
_OPTIONS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--mute-audio",
            "--disable-background-networking", "--remote-debugging-pipe", "--window-size=1180,860", "--lang=en")  # fmt: skip


class Browser:
    """Represents one page, and the errors in it (`problems`)."""

    def __init__(self, folder: Path) -> None:
        """Starts the browser with its profile in `folder`."""
        assert PROGRAM
        self.problems: list[str] = []
        inbox, to_browser = os.pipe()
        from_browser, outbox = os.pipe()
        # Chromium reads descriptor 3 and writes descriptor 4.
        redirect = f'exec "$@" 3<&{inbox} 4>&{outbox}'
        with (folder / "chromium.log").open("wb") as log:
            self._process = subprocess.Popen(
                ["bash", "-c", redirect, "bash", PROGRAM, *_OPTIONS, f"--user-data-dir={folder / 'profile'}"],
                pass_fds=(inbox, outbox), stderr=log, stdout=log, start_new_session=True,
                env={**os.environ, "HOME": str(folder)},
            )  # fmt: skip
        os.close(inbox)
        os.close(outbox)
        self._to = os.fdopen(to_browser, "wb", buffering=0)
        self._from = os.fdopen(from_browser, "rb", buffering=0)
        self._rest = b""
        self._count = 0
        self._session: str | None = None

    def __enter__(self) -> Browser:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            self._to.close()  # the browser ends when its pipe closes
            self._process.wait(20)
        finally:
            self._from.close()
            try:
                os.killpg(self._process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self._process.wait()

    def open(self, address: str) -> None:
        """Opens a page in place of the current one."""
        if self._session is None:
            target = self.send("Target.createTarget", url="about:blank")["targetId"]
            self._session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            self.send("Runtime.enable")
        self.send("Page.navigate", url=address)

    def send(self, method: str, **params: Any) -> dict[str, Any]:
        """Returns the result of a command. Other messages of the browser are only checked for errors."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": params}
        if self._session is not None:
            message["sessionId"] = self._session
        self._to.write(json.dumps(message).encode() + b"\0")
        while (reply := self._next()).get("id") != self._count:
            if reply.get("method") == "Runtime.exceptionThrown":
                self.problems.append(json.dumps(reply["params"]["exceptionDetails"])[:2000])
        assert "error" not in reply, reply
        result: dict[str, Any] = reply["result"]
        return result

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            piece = os.read(self._from.fileno(), 1 << 16)
            assert piece, "the browser has gone"
            self._rest += piece
        message, _, self._rest = self._rest.partition(b"\0")
        event: dict[str, Any] = json.loads(message)
        return event

    def evaluate(self, script: str) -> Any:
        """Returns the value of a JavaScript expression in the page."""
        reply = self.send("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in reply, reply
        return reply["result"].get("value")

    def text(self, selector: str = "body") -> str:
        """Returns the visible text; "" if there is none."""
        found: str = self.evaluate(f"document.querySelector({json.dumps(selector)})?.innerText ?? ''")
        return found

    def wait_for(self, words: str, selector: str = "body") -> None:
        """Waits until the words are visible."""
        eventually(lambda: words in self.text(selector))

    def click(self, selector: str, words: str = "") -> None:
        """Clicks the first element that contains the words, as soon as it exists."""
        found = f"[...document.querySelectorAll({json.dumps(selector)})].find(e => e.innerText.includes({json.dumps(words)}))"
        eventually(lambda: self.evaluate(f"!!{found}"))
        self.evaluate(f"{found}.click()")

    def resize(self, width: int, height: int) -> None:
        """Sets the window size that the page sees."""
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

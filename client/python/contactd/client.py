"""The client: one method of Python for each method of the daemon."""

from __future__ import annotations

import math
import secrets
import time
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

from . import problem as asked
from .arrays import Frames, decode, encode, invalid, plain
from .connections import Connections, Lender
from .curve import load_curve_keys
from .errors import InvalidArgument, ProtocolError, StatusError, TimeoutExpired, Unauthenticated
from .many_steps import stepped_sessions
from .messages import CLIENT, PROTOCOL_VERSION, Reply, Request
from .outcomes import outcomes
from .partial import Fields, PartialSolution, names_of, read_solution
from .pieces import fetch_in_pieces
from .problem import ContactProblem, Estimate, Grid, Ics, LayeredBody, Material
from .reading import read
from .session import Session, SessionSummary, joined_session, listed_sessions, opened_session
from .showing import Rows, Shown
from .solution import ContactSolution, IcTable, Job, Limits, Progress, QuarantinedIc, ServerInfo, StoredIc
from .steps import StepInput, StepSolution
from .subsurface import StressBlock, SubsurfaceStress, subsurface_params
from .waiting import may_build, say_that_the_build_goes_on, seconds_of, spin_of
from .wheel_rail import WheelRailSetup, WheelRailState
from .wheel_rail_params import setup_params, state_params
from .wheel_rail_solution import EquivalentConicity, WheelRailGeometry, WheelRailSolution, read_wheel_rail

__all__ = ["Client"]

ProgressCallback = Callable[[Progress], None]


class Client(Shown):
    """Speaks with the daemon at `endpoint`, such as ``tcp://127.0.0.1:5555`` or ``ipc:///run/contactd.socket``.

    Connects with the first call. Safe to share between threads: every call has a socket of its own for as long as it
    lasts, so calls of several threads run side by side, and a progress callback may call the client. A process that is
    forked (multiprocessing, Dask) goes on with connections of its own, and a client that is pickled connects anew where
    it arrives; the key files are read there again, by their paths: no key is ever pickled.

    Times are in seconds, None for a day, the longest there is. `timeout` holds for each call that is not given its own,
    but `build_timeout` for those that may have to wait for tables by finite elements (FemIcs); `connect_timeout` bounds
    the wait for a daemon to listen. A timeout ends the waiting and not a build: the exception says how to follow it.

    `spin` is how long a call looks for its answer before its thread sleeps (s). It saves the 20 to 50 us that waking it
    takes, and keeps a processor busy meanwhile; 0, the default, sleeps at once.

    With the files `server_key` (the daemon's public key) and `own_key` (the secret key of this client, which the daemon
    has to know) the connection is encrypted; docs/security.md says how to make them.

    A call that is interrupted (Ctrl-C, an exception of the progress callback) or times out is cancelled and leaves the
    client usable; the daemon finishes a build for its cache, unless `cancel_job` ends it.

    Every method raises StatusError (a subclass per status), TimeoutExpired, ConnectionFailed or ProtocolError.
    """

    def __init__(
        self,
        endpoint: str,
        *,
        timeout: float | None = 60.0,
        build_timeout: float | None = 3600.0,
        connect_timeout: float | None = 5.0,
        server_key: str | Path | None = None,
        own_key: str | Path | None = None,
        spin: float = 0.0,
    ) -> None:
        self.endpoint = endpoint
        self.spin = spin_of(spin)
        self.timeout = seconds_of("timeout", timeout)
        self.build_timeout = seconds_of("build_timeout", build_timeout)
        self.connect_timeout = seconds_of("connect_timeout", connect_timeout)
        self._curve = load_curve_keys(server_key, own_key)
        self._key_files = [None if key is None else Path(key).absolute() for key in (server_key, own_key)]
        self._connections = self._lender()
        self._limits: Limits | None = None

    def _lender(self) -> Lender:
        return Connections(self.endpoint, self._curve, self.spin)

    def __getstate__(self) -> dict[str, Any]:
        names = ("endpoint", "timeout", "build_timeout", "connect_timeout", "spin")
        server_key, own_key = self._key_files
        return {**{name: getattr(self, name) for name in names}, "server_key": server_key, "own_key": own_key}

    def __setstate__(self, state: dict[str, Any]) -> None:
        Client.__init__(self, **state)

    def _title(self) -> str:
        return f"Client of {self.endpoint}"

    def _rows(self) -> Rows:
        rows: Rows = [("timeout", f"{self.timeout:g} s"), ("builds", f"{self.build_timeout:g} s")]
        rows.append(("encryption", "none" if self._curve is None else f"as {self._curve.public.decode()[:8]}..."))
        return [*rows, ("state", "closed" if self._connections.is_closed else "open")]

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connections; calls still running in other threads keep theirs until they return."""
        self._connections.close()

    def info(self, *, timeout: float | None = None) -> ServerInfo:
        """Versions, limits and counters of the daemon."""
        return read(ServerInfo, self.call("server.info", timeout=timeout))

    def health(self, *, timeout: float | None = None) -> str:
        """``"serving"`` or ``"stopping"``; never waits for other work."""
        state = self.call("server.health", timeout=timeout).get("state")
        if not isinstance(state, str):
            raise ProtocolError("The answer to server.health lacks its state.")
        return state

    def metrics(self, *, timeout: float | None = None) -> list[dict[str, Any]]:
        """What is measured of the daemon, as docs/operations.md lists it: name, type, help and samples of each."""
        metrics = self.call("server.metrics", timeout=timeout).get("metrics")
        if not isinstance(metrics, list):
            raise ProtocolError("The answer to server.metrics lacks its metrics.")
        return metrics

    def watch_health(self, on_state: Callable[[str], None], *, timeout: float | None = None) -> str:
        """Calls `on_state` with the state of the daemon, at once and whenever it changes, until the daemon ends.

        Returns the last state, ``"stopping"``. An exception of `on_state` ends the watch.
        """
        last = ""

        def report(progress: Progress) -> None:
            nonlocal last
            if progress.state != last:
                last = progress.state
                on_state(last)

        state = self.call("health.watch", timeout=timeout, on_progress=report).get("state")
        if not isinstance(state, str):
            raise ProtocolError("The answer to health.watch lacks its state.")
        if state != last:
            on_state(state)
        return state

    def describe(self, *, timeout: float | None = None) -> dict[str, Any]:
        """The OpenRPC document of the daemon, with the JSON Schema of every message."""
        return self.call("server.describe", timeout=timeout)

    def get_ic(
        self,
        material: Material | LayeredBody,
        grid: Grid,
        ics: Ics,
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> IcTable:
        """The influence coefficients of one body; built when no cache has them, which may take minutes.

        A timeout ends the waiting, not the build. A table that is too large for one message comes in several, each with
        the same timeout.
        """
        params = asked.table_params(material, grid, ics)

        def ask(params: dict[str, Any]) -> dict[str, Any]:
            return self.call("ic.get", params, timeout=timeout, on_progress=on_progress)

        try:
            result = ask(params)
        except InvalidArgument as error:
            if error.reason != "ANSWER_TOO_LARGE":
                raise
            result = fetch_in_pieces(ask, params, grid, self.info(timeout=timeout).limits)
        result["array"] = result.pop("table", None)
        table = read(IcTable, result)
        _check_shapes(table, ["array"], (3, 3, *grid.shape))
        return table

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
    ) -> bytes:
        """The table of get_ic as the content of a file: "hdf5" (docs/ic-tables.md), or "contact", the text in which the
        CONTACT program takes the coefficients of a pair of bodies, of which `lower` is the second (None: as the first).
        """
        params = {**asked.table_params(material, grid, ics), "format": format}
        if lower is not None:
            params["lower"] = plain(lower)
        result = self.call("ic.export", params, timeout=timeout, on_progress=on_progress)
        content = result.get("file", result.get("text"))
        if isinstance(content, str):
            return content.encode()
        if not isinstance(content, np.ndarray) or content.dtype != np.uint8:
            raise ProtocolError("The answer to ic.export lacks its file.")
        return content.tobytes()

    def stored_ics(self, *, timeout: float | None = None) -> Iterator[StoredIc]:
        """The tables in the daemon's store, by name; asked for a thousand at a time."""
        params: dict[str, Any] = {}
        while True:
            result = self.call("ic.list", params, timeout=timeout)
            tables = result.get("tables")
            if not isinstance(tables, list):
                raise ProtocolError("The answer to ic.list lacks its tables.")
            yield from (read(StoredIc, table, f"result.tables[{i}]") for i, table in enumerate(tables))
            if "next" not in result:
                return
            params = {"after": result["next"]}

    def quarantined_ics(self, *, timeout: float | None = None) -> tuple[QuarantinedIc, ...]:
        """Tables whose builds failed too often: requests for them raise FailedPrecondition, with .retry_delay (s)."""
        entries = self.call("ic.list", {"limit": 1}, timeout=timeout).get("quarantined")
        if not isinstance(entries, list):
            raise ProtocolError("The answer to ic.list lacks its builds in quarantine.")
        return tuple(read(QuarantinedIc, entry, f"result.quarantined[{i}]") for i, entry in enumerate(entries))

    def delete_ic(self, key: str, *, timeout: float | None = None) -> int:
        """Removes the tables of a key from the daemon's store and ends its quarantine; returns how many tables went.

        Raises NotFound when there was nothing to do.
        """
        removed = self.call("ic.delete", {"key": key}, timeout=timeout).get("tables")
        if not isinstance(removed, int):
            raise ProtocolError("The answer to ic.delete lacks the number of tables.")
        return removed

    @overload
    def solve(
        self,
        problem: ContactProblem | None = None,
        /,
        *,
        fields: None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        **problem_fields: Any,
    ) -> ContactSolution: ...
    @overload
    def solve(
        self,
        problem: ContactProblem | None = None,
        /,
        *,
        fields: Fields,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        **problem_fields: Any,
    ) -> PartialSolution: ...
    def solve(
        self,
        problem: ContactProblem | None = None,
        /,
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        **problem_fields: Any,
    ) -> ContactSolution | PartialSolution:
        """Solves a ContactProblem, given whole or by its fields. Look at `converged` of the solution.

        `fields` names the arrays wanted back, or the one, and the others are None; ``fields=[]`` brings forces, areas and
        the rest that is no array, for less. Left out, all arrays come.
        """
        if problem is None:
            problem = ContactProblem(**problem_fields)
        elif problem_fields:
            raise TypeError(f"solve() takes a ContactProblem or its fields, not both: {', '.join(problem_fields)}")
        asked.check_type("problem", problem, ContactProblem)
        names = None if fields is None else names_of(fields)
        params = asked.problem_params(problem, names)
        result = self.call("contact.solve", params, timeout=timeout, on_progress=on_progress)
        return read_solution(problem.grid, names, result)

    @overload
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> list[ContactSolution | StatusError]: ...
    @overload
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> list[PartialSolution | StatusError]: ...
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> list[Any]:
        """Solves 1 to 1000 problems at once, on all workers of the daemon; the answers are in the order of the problems.

        Where a problem fails, its answer is the exception that `solve` would have raised, and the others are solved all
        the same::

            for answer in client.solve_many(problems):
                if isinstance(answer, StatusError):
                    print(answer.message, answer.violations)
                else:
                    print(answer.Fx, answer.converged)

        `fields` names the arrays wanted back of each, as for `solve`.

        Raises InvalidArgument for the whole when a problem lacks a field or has one out of its range, which it names
        like ``problems[3].grid.nx``, and LIMIT_EXCEEDED when their grids or arrays are too large together. An array that
        several problems share (a gap, TableIcs) is sent once.
        """
        problems = list(problems)
        if not problems:
            return []
        for index, problem in enumerate(problems):
            asked.check_type(f"problems[{index}]", problem, ContactProblem)
        names = None if fields is None else names_of(fields)
        params = {"problems": [asked.problem_params(problem, names) for problem in problems]}
        result = self.call("contact.solve_many", params, timeout=timeout, on_progress=on_progress)
        readers = [partial(read_solution, problem.grid, names) for problem in problems]
        return outcomes("contact.solve_many", result, "solutions", readers)

    def subsurface(
        self,
        problem: ContactProblem,
        solution: ContactSolution | Estimate,
        *,
        body: Literal["lower", "upper"] = "lower",
        points: npt.ArrayLike | None = None,
        block: StressBlock | None = None,
        nu: float | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> SubsurfaceStress:
        """Stresses inside a body, a half-space, under the tractions of the `solution` of a `problem`.

        They are wanted either at `points`, shape [n, 3] (x, y, z in mm), or on a `block`::

            stress = client.subsurface(problem, solution, block=StressBlock(x=grid.x, y=0, z=-np.linspace(0, 5, 51)))
            print(stress.largest.von_mises, stress.largest.depth)

        Points and stresses are in the frame of `body`, where z <= 0 is inside, for the upper body too: see
        SubsurfaceStress. `nu` is Poisson's ratio of the body, where it is not that of the problem. Nearer to the surface
        than an element the steps of the tractions show. A block and TableIcs, which are no half-spaces or may be none,
        are refused (InvalidArgument).
        """
        params, shape = subsurface_params(problem, solution, body, points, block, nu)
        result = self.call("contact.subsurface", params, timeout=timeout, on_progress=on_progress)
        components = result.pop("stress", None)
        stress = read(SubsurfaceStress, {**result, **components} if isinstance(components, dict) else result)
        _check_shapes(stress, ["xx", "yy", "zz", "xy", "xz", "yz", "von_mises"], shape)
        return stress

    def wheel_rail(
        self,
        setup: WheelRailSetup,
        state: WheelRailState,
        *,
        fields: Fields | None = None,
        gap: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> WheelRailSolution:
        """The contact of a wheel with its rail: patches, and forces on the rail. `contactd.wheel_rail` says how to ask.

        `fields` names the arrays wanted back of each patch, as for `solve`; `gap` asks for the undeformed distances.
        A set-up that was asked for before costs less: the daemon keeps its profiles and operators. Raises InvalidArgument
        naming ``setup.track.gauge``, ``state.position.z``, ...
        """
        names = None if fields is None else names_of(fields)
        params: dict[str, Any] = {"setup": setup_params(setup), "state": state_params(state, "state")}
        if names is not None:
            params["fields"] = names
        if gap:
            params["gap"] = True
        result = self.call("wheelrail.solve", params, timeout=timeout, on_progress=on_progress)
        return read_wheel_rail(names, gap, result)

    def wheel_rail_geometry(
        self,
        setup: WheelRailSetup,
        states: Iterable[WheelRailState],
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> list[WheelRailGeometry]:
        """Where a wheel touches its rail in 1 to 1000 states, without a solve: contact points, angles, radii, creepages.

        Where a state has Fz the wheelset stands at the height at which Hertz's theory expects that force.
        """
        listed = list(states)
        if not listed:
            return []
        given = [state_params(state, f"states[{index}]") for index, state in enumerate(listed)]
        params = {"setup": setup_params(setup), "states": given}
        result = self.call("wheelrail.geometry", params, timeout=timeout, on_progress=on_progress)
        geometries = result.get("geometries")
        if not isinstance(geometries, list) or len(geometries) != len(given):
            raise ProtocolError("The answer to wheelrail.geometry lacks a geometry for each state.")
        return [read(WheelRailGeometry, item, f"result.geometries[{i}]") for i, item in enumerate(geometries)]

    def equivalent_conicity(
        self,
        setup: WheelRailSetup,
        amplitudes: Iterable[float],
        *,
        roll: Literal["demanded", "neglected"] | None = None,
        contact_distance: float | None = None,
        tolerance: float | None = None,
        timeout: float | None = None,
    ) -> list[EquivalentConicity]:
        """The equivalent conicity of a wheelset with the profiles of the set-up on both sides, for 1 to 100 amplitudes
        (mm): integrated over the kinematic motion (EN 15302), and by the harmonic approximation.

        `roll` is "neglected" (default), by which a cone has its own conicity, or as both contacts demand. `contact_distance`
        is that between the contact points of both wheels (mm, default 1500), `tolerance` that of the radius difference
        (mm, default 1e-3).
        """
        given = {"roll": roll, "contact_distance": contact_distance, "tolerance": tolerance}
        wanted = {"amplitudes": list(amplitudes), **{name: v for name, v in given.items() if v is not None}}
        params = {"setup": setup_params(setup), "conicity": wanted}
        conicities = self.call("wheelrail.geometry", params, timeout=timeout).get("conicities")
        if not isinstance(conicities, list):
            raise ProtocolError("The answer to wheelrail.geometry lacks the conicities.")
        return [read(EquivalentConicity, item, f"result.conicities[{i}]") for i, item in enumerate(conicities)]

    def session(
        self,
        problem: ContactProblem | None = None,
        /,
        *,
        lease: float | None = None,
        accept_unconverged: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        **fields: Any,
    ) -> Session:
        """Opens a Session, which says more: the steps of a simulation.

        What its steps have in common is given as a ContactProblem, as to `solve`, or by its fields, of which `gap`,
        `approach` or `Fn`, and `friction` may be left to the steps.
        """
        if problem is not None:
            asked.check_type("problem", problem, ContactProblem)
            if fields:
                raise TypeError(f"session() takes a ContactProblem or its fields, not both: {', '.join(fields)}")
            fields = vars(problem)
        return opened_session(self, fields, lease, accept_unconverged, timeout, on_progress)

    def join_session(self, name: str, *, timeout: float | None = None) -> Session:
        """The session with this name (Session.name), where its last step left it, whoever opened it and wherever.

        Raises NotFound when it has ended. Two who share a session take turns, and must tell each other: the number of a
        step that the other one has taken is refused (FailedPrecondition) or, asked for in the same words, answered as the
        other one was.
        """
        return joined_session(self, name, timeout)

    def step_many(
        self, steps: Iterable[tuple[Session, StepInput]], *, timeout: float | None = None
    ) -> list[StepSolution | StatusError]:
        """Takes the next step of 1 to 1000 sessions of this client in one message, on all workers of the daemon: of all
        contacts of a vehicle. Each is told as the session and the keywords of its step::

            answers = client.step_many([(left, {"Fn": 51e3, "xi": 1e-3}), (right, {"Fn": 49e3, "xi": -1e-3})])

        The answers are in the order of the steps. Where a step fails, its answer is the exception that Session.step would
        have raised; its session stays where it was, and the others take their steps all the same. With ``"again": True``
        in each, all are tried anew, those that failed, too. An array that several steps share (a gap) is sent once.

        Raises InvalidArgument for the whole, before any session has moved, when a step has a field that the schema does
        not allow, which it names like ``steps[3].friction.mu``, and when a session stands twice or is of another client;
        ContactdError while another call of one of the sessions runs.

        Steps whose answer does not come are asked for again under their numbers, as often as all of the sessions'
        `retries` allow. When the whole fails (a timeout, Ctrl-C), some have taken their steps and others have not: the
        same steps asked for again go on from there, and so do others with ``"again": True``.
        """
        return stepped_sessions(self, steps, timeout)

    def sessions(self, *, timeout: float | None = None) -> tuple[SessionSummary, ...]:
        """Ages and counts of the open sessions, oldest first."""
        return listed_sessions(self.call("session.list", timeout=timeout))

    def jobs(self, *, timeout: float | None = None) -> tuple[Job, ...]:
        """Work that waits or runs."""
        jobs = self.call("job.list", timeout=timeout).get("jobs")
        if not isinstance(jobs, list):
            raise ProtocolError("The answer to job.list lacks its jobs.")
        return tuple(read(Job, job, f"result.jobs[{i}]") for i, job in enumerate(jobs))

    def cancel_job(self, job: str, *, timeout: float | None = None) -> None:
        """Ends a job; every call that waits for it raises Cancelled."""
        self.call("job.cancel", {"job": job}, timeout=timeout)

    def call(
        self,
        method: str,
        params: dict[str, Any] | None = None,
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> dict[str, Any]:
        """Any method of the daemon by its name: plain JSON and numpy arrays in, the same out.

        `timeout` in seconds; None: the client's `build_timeout` where the request may have to wait for finite elements,
        else its `timeout`.
        """
        builds = may_build(params or {})
        usual = self.build_timeout if builds else self.timeout
        seconds = seconds_of("timeout", usual if timeout is None else timeout)
        deadline = time.monotonic() + seconds
        frames = Frames()
        envelope = {
            "contactd": PROTOCOL_VERSION,
            "id": secrets.token_hex(8),
            "method": method,
            "timeout_ms": math.ceil(seconds * 1000),
            "metadata": {"client": CLIENT},
            "params": encode(params or {}, "", frames),
        }
        if frames:
            self._check_limits(frames, deadline)
        build = ""

        def notice(progress: Progress) -> None:
            nonlocal build
            if progress.job.startswith("build-"):
                build = progress.job
            if on_progress is not None:
                on_progress(progress)

        def report(progress: dict[str, Any]) -> None:
            notice(read(Progress, progress, "progress"))

        try:
            reply = self._exchange(Request(envelope, frames, deadline, self.connect_timeout, report))
        except TimeoutExpired as error:
            if builds:
                say_that_the_build_goes_on(error, build)
            raise
        if not reply.frames:  # nothing to decode; server.describe speaks of "$array" without meaning one
            return reply.result
        result: dict[str, Any] = decode(reply.result, reply.frames)
        return result

    def _exchange(self, request: Request) -> Reply:
        connection = self._connections.take()
        try:
            reply = connection.exchange(request)
        except (StatusError, TimeoutExpired) as error:
            # A socket whose handshake was refused never connects again.
            self._connections.give_back(connection, usable=not isinstance(error, Unauthenticated))
            raise
        except BaseException:
            # An interrupt may have come between two frames of a message: this socket cannot be trusted any more.
            self._connections.give_back(connection, usable=False)
            raise
        self._connections.give_back(connection)
        return reply

    def _check_limits(self, frames: list[bytes], deadline: float) -> None:
        """Refuses here what the daemon would refuse, before many megabytes are sent for nothing."""
        if self._limits is None:
            self._limits = self.info(timeout=max(1e-3, deadline - time.monotonic())).limits
        limits = self._limits
        for n, frame in enumerate(frames, 1):
            _check_limit(f"array frame {n}", len(frame) // 8, limits.max_array_elements, "numbers")
            _check_limit(f"array frame {n}", len(frame), limits.max_frame_bytes, "bytes")
        _check_limit("the request", len(frames) + 1, limits.max_frames, "frames")
        _check_limit("the request", sum(map(len, frames)), limits.max_message_bytes, "bytes")


def _check_limit(what: str, size: int, limit: int, unit: str) -> None:
    if size > limit:
        raise invalid(what, f"has {size} {unit}; the daemon takes at most {limit}", "LIMIT_EXCEEDED")


def _check_shapes(answer: Any, names: Iterable[str], shape: tuple[int, ...]) -> None:
    for name in names:
        if (found := getattr(answer, name).shape) != shape:
            raise ProtocolError(f"The answer's {name} has shape {list(found)} instead of {list(shape)}.")

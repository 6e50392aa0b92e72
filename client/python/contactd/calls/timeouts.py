"""Timeouts of calls, and repetitions of calls without an answer."""

from __future__ import annotations

from numbers import Real
from typing import Any

from ..errors import StatusError, TimeoutExpired

__all__ = ["LONGEST", "may_build", "say_that_the_build_goes_on", "seconds_of", "spin_of", "wheel_may_build"]

LONGEST = 86_400.0  #: Maximum time of a call (s).


def seconds_of(name: str, value: Any) -> float:
    """Returns a timeout from the caller's argument (s); None is the maximum. Raises TypeError or ValueError."""
    if value is None:
        return LONGEST
    right = f"it must be a number of seconds, more than 0 and at most {LONGEST:g}, or None for this maximum"
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"{name} is {value!r}; {right}")
    seconds = float(value)
    if not 0 < seconds <= LONGEST:
        raise ValueError(f"{name} is {value}; {right}")
    return seconds


def spin_of(value: Any) -> float:
    """A time to look for answers without sleeping (s). Raises TypeError or ValueError."""
    right = "it must be a number of seconds from 0, the default, to 1"
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"spin is {value!r}; {right}")
    seconds = float(value)
    if not 0 <= seconds <= 1:
        raise ValueError(f"spin is {value}; {right}")
    return seconds


def may_build(params: dict[str, Any]) -> bool:
    """Whether a request with these parameters may have to wait for tables by finite elements."""
    if "state" in params:  # one state of a wheel on its rail, or both states
        return any(wheel_may_build(params.get(setup)) for setup in ("setup", "left"))
    problems = params.get("problems", [params])
    return any(_asks_for_finite_elements(problem) for problem in problems if isinstance(problem, dict))


def wheel_may_build(setup: Any) -> bool:
    """Whether a wheel on its rail with this set-up may have to wait for tables by finite elements."""
    return isinstance(setup, dict) and setup.get("conformal") == "fem" and setup.get("model", "full") == "full"


def _asks_for_finite_elements(problem: dict[str, Any]) -> bool:
    if problem.get("model", "full") != "full":
        return False
    bodies = problem.get("bodies")
    holders = [problem, *(bodies.values() if isinstance(bodies, dict) else ())]
    sources = [holder.get("ics") for holder in holders if isinstance(holder, dict)]
    return any(isinstance(ics, dict) and ics.get("source") == "fem" for ics in sources)


def say_that_the_build_goes_on(error: TimeoutExpired, job: str) -> None:
    """Adds the fate of the build that the call has waited for to `error`. `job` is its name, or "" if it is
    unknown."""
    what = f"The build continues in the daemon as job {job}" if job else "The build that it waited for continues in the daemon"
    end = f"cancel_job({job!r})" if job else "cancel_job()"
    advice = f"{what}. jobs() reports its progress, {end} ends it, and repeating the call joins it or returns its table."
    if isinstance(error, StatusError):
        error.message = f"{error.message} {advice}"
    error.args = (f"{error.args[0]} {advice}",)

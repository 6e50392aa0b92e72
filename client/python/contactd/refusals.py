"""How this package refuses what it is given: checks of types, the name that was meant, and tracebacks that end where the caller's line is."""

from __future__ import annotations

import difflib
import functools
import inspect
import os
import reprlib
import sys
from collections.abc import Callable, Iterable
from types import FrameType
from typing import Any, TypeVar, cast

__all__ = ["check_either", "check_type", "did_you_mean", "package_of", "public"]

F = TypeVar("F", bound=Callable[..., Any])

#: These types refuse, beside the exceptions of this package. All else that leaves a call is a defect, or the caller's own.
_REFUSALS = (TypeError, ValueError, OSError, ImportError, Warning)
#: Packages whose frames tell a caller nothing: this one, and the library of Python that it calls.
_INSIDE = {__name__.partition(".")[0], *sys.stdlib_module_names}
_LONGEST_NAME = 100
_LEAST_LIKENESS = 0.6
_SWITCH = "CONTACTD_TRACEBACK"  #: "full" leaves tracebacks as they are


def check_type(name: str, value: object, *types: type, optional: bool = False) -> None:
    """Raises TypeError when `value` is of none of the types; what is in it is the daemon's business."""
    if isinstance(value, types) or (optional and value is None):
        return
    words = " or ".join(kind.__name__ for kind in types)
    raise TypeError(f"{name} is {reprlib.repr(value)}; it must be of type {words}")


def check_either(call: str, words: str, **two: object) -> None:
    """Raises TypeError unless just one of two arguments is given; `words` name both, as in "approach or Fn"."""
    given = [name for name, value in two.items() if value is not None]
    if len(given) != 1:
        problem = f"has both {' and '.join(two)}" if given else f"lacks {' or '.join(two)}"
        raise TypeError(f"{call}() {problem}; it takes either {words}")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A question behind a refusal, with a blank before it; empty where no known name is like this one."""
    names = list(known)
    lowered = {one.lower(): one for one in names}
    near = difflib.get_close_matches(name[:_LONGEST_NAME].lower(), lowered, 1, _LEAST_LIKENESS)
    return f" Did you mean {lowered[near[0]]}?" if near else ""


def public(call: F) -> F:
    """A function, coroutine or class that users call: the traceback of what it refuses ends at the line that called it.

    Frames of the caller's own, such as those of a progress callback, stay. So does the whole traceback of a defect.
    """
    if isinstance(call, type):
        kind: Any = call
        kind.__init__ = public(kind.__init__)
        return cast(F, kind)
    if inspect.iscoroutinefunction(call):

        @functools.wraps(call)
        async def awaited(*args: Any, **keywords: Any) -> Any:
            try:
                return await call(*args, **keywords)
            except Exception as error:
                _shorten_traceback(error)
                raise  # which adds no frame; before Python 3.11 it brings back those that were there

        return cast(F, awaited)

    @functools.wraps(call)
    def called(*args: Any, **keywords: Any) -> Any:
        try:
            return call(*args, **keywords)
        except Exception as error:
            _shorten_traceback(error)
            raise

    return cast(F, called)


def package_of(frame: FrameType) -> str:
    """The package, or the module outside of packages, whose code a frame runs."""
    return str(frame.f_globals.get("__name__", "")).partition(".")[0]


def _shorten_traceback(error: Exception) -> None:
    """Takes off the frames down to the first that is neither of this package nor of Python."""
    is_defect = getattr(error, "is_defect", not isinstance(error, _REFUSALS))
    if is_defect or os.environ.get(_SWITCH) == "full":
        return
    rest = error.__traceback__
    while rest is not None and package_of(rest.tb_frame) in _INSIDE:
        rest = rest.tb_next
    if rest is None:
        error.__suppress_context__ = True  # what was handled here meanwhile; a cause that was named stays
    error.__traceback__ = rest

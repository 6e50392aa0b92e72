"""Refusals of arguments: type checks, suggestions for misspelt names, and tracebacks that end at the caller's line."""

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

#: These types are refusals, like the exceptions of this package. Others are defects, or exceptions of the caller.
_REFUSALS = (TypeError, ValueError, OSError, ImportError, Warning)
#: Packages whose frames are hidden: this one, and the Python libraries that it calls.
_INSIDE = {__name__.partition(".")[0], *sys.stdlib_module_names}
_LONGEST_NAME = 100
_LEAST_LIKENESS = 0.6
_SWITCH = "CONTACTD_TRACEBACK"  #: The value "full" keeps complete tracebacks.


def check_type(name: str, value: object, *types: type, optional: bool = False) -> None:
    """Raises TypeError if `value` has none of the types; the daemon checks its content."""
    if isinstance(value, types) or (optional and value is None):
        return
    words = " or ".join(kind.__name__ for kind in types)
    raise TypeError(f"{name} is {reprlib.repr(value)}; it must be of type {words}")


def check_either(call: str, words: str, **two: object) -> None:
    """Raises TypeError unless exactly one of two arguments is given; `words` name both, as in "approach or Fn"."""
    given = [name for name, value in two.items() if value is not None]
    if len(given) != 1:
        problem = f"has both {' and '.join(two)}" if given else f"lacks {' or '.join(two)}"
        raise TypeError(f"{call}() {problem}; give either {words}")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Returns a question to append to a refusal, with a leading blank; empty if no known name is similar."""
    names = list(known)
    lowered = {one.lower(): one for one in names}
    near = difflib.get_close_matches(name[:_LONGEST_NAME].lower(), lowered, 1, _LEAST_LIKENESS)
    return f" Did you mean {lowered[near[0]]}?" if near else ""


def public(call: F) -> F:
    """Marks a function, coroutine or class for users: the traceback of its refusals ends at the caller's line.

    Frames of the caller, such as those of a progress callback, are kept, and so is the whole traceback of a defect.
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
                raise  # A bare raise adds no frame. Before Python 3.11 it restores the removed ones.

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
    """Returns the package of a frame's code, or the module outside packages."""
    return str(frame.f_globals.get("__name__", "")).partition(".")[0]


def _shorten_traceback(error: Exception) -> None:
    """Removes the frames down to the first that belongs neither to this package nor to Python."""
    is_defect = getattr(error, "is_defect", not isinstance(error, _REFUSALS))
    if is_defect or os.environ.get(_SWITCH) == "full":
        return
    rest = error.__traceback__
    while rest is not None and package_of(rest.tb_frame) in _INSIDE:
        rest = rest.tb_next
    if rest is None:
        error.__suppress_context__ = True  # Hides exceptions that were handled internally. An explicit cause is kept.
    error.__traceback__ = rest

"""Provides fixtures of FMUs. Their tests are skipped if ./dev could not get FMI's headers from PyPI."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path

import pytest

from integration.conftest import daemons, shared_daemon  # noqa: F401
from support.fmus import PACKAGES, VERSIONS, Fmu


@pytest.fixture(autouse=True)
def _fmpy() -> None:
    if PACKAGES is None:
        pytest.skip("this build has no FMUs: FMI's headers come from PyPI, which ./dev could not reach")


@pytest.fixture(params=VERSIONS, ids=lambda version: f"FMI {version}")
def fmi(request: pytest.FixtureRequest) -> int:
    """Each version of FMI."""
    version: int = request.param
    return version


@pytest.fixture
def instances(tmp_path: Path) -> Iterator[Callable[..., Fmu]]:
    """Makes instances, of a kind and a version, that are freed at the end."""
    with ExitStack() as stack:
        yield lambda kind, version, **options: stack.enter_context(Fmu(kind, version, tmp_path, **options))


@pytest.fixture
def contact(instances: Callable[..., Fmu], fmi: int) -> Callable[..., Fmu]:
    return partial(instances, "contactd_contact", fmi)


@pytest.fixture
def wheel(instances: Callable[..., Fmu], fmi: int) -> Callable[..., Fmu]:
    return partial(instances, "contactd_wheel", fmi)


@pytest.fixture
def refused() -> Callable[..., None]:
    """Checks that a call is refused with a status, and a sentence in the log."""
    from fmpy.fmi1 import FMICallException

    def check(fmu: Fmu, call: Callable[[], object], *words: str, status: int = 3) -> None:
        with pytest.raises(FMICallException) as caught:
            call()
        assert caught.value.status == status
        told_status, category, sentence = fmu.log[-1]
        assert (told_status, category) == (status, "errors")
        assert all(word in sentence for word in words), sentence

    return check

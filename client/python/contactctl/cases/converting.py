"""Converts cases to input of contactd: YAML for `contactctl solve` and `contactctl wheelrail solve`, or Python."""

from __future__ import annotations

from typing import Any

import click

from contactd.files.marks import written_by
from contactd.values.generated.contact_files import ConvertedCase

from ..output import plain_json

__all__ = ["as_yaml", "case_params"]


def case_params(case: ConvertedCase) -> dict[str, Any]:
    """Returns the parameters of contact.solve or wheelrail.solve. Raises click.UsageError for a case without them."""
    where = f"Case {case.number} in line {case.line}"
    params = case.wheelrail if case.contact is None else case.contact
    if params is None:
        raise click.UsageError(f"{where} is {case.status}: {case.sentence}")
    if case.continues:
        raise click.UsageError(f"{where} continues the previous case: convert to Python.")
    return dict(params)


def as_yaml(case: ConvertedCase) -> str:
    """Returns the case as YAML text. Raises click.UsageError for a case without parameters."""
    import yaml

    text: str = yaml.safe_dump(plain_json(case_params(case)), sort_keys=False, default_flow_style=None, width=120)
    return f"# Case {case.number}, line {case.line}, {written_by()}.\n{text}"

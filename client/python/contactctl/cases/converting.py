"""Converts cases to input of contactd: YAML for `contactctl solve` and `contactctl wheelrail solve`, or Python."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from contactd import Client, ContactProblem, TableFileError
from contactd.contact_files.case import Case
from contactd.contact_files.problems.basic import BasicContact, goes_on
from contactd.contact_files.problems.features import Missing
from contactd.contact_files.problems.mistakes import mistakes
from contactd.contact_files.problems.rails import RailContact
from contactd.contact_files.profile_files import ProfileFiles
from contactd.contact_files.python_text import python_text
from contactd.files.marks import written_by
from contactd.values.contact_params import problem_params
from contactd.values.wheel_rail.params import setup_params, state_params

from ..output import plain_json

__all__ = ["as_python", "as_yaml", "case_params"]


def case_params(case: Case, client: Client, profiles: ProfileFiles) -> dict[str, Any]:
    """Returns the parameters of contact.solve or wheelrail.solve. Raises click.UsageError for a case without them."""
    contact = _made(case, client, profiles)
    if isinstance(contact, str):
        raise click.UsageError(contact)
    if goes_on(case):
        raise click.UsageError(f"Case {case.number} in line {case.line} continues the previous case: convert to Python.")
    if isinstance(contact, RailContact):
        return {"setup": setup_params(contact.setup), "state": state_params(contact.state, "state")}
    return problem_params(contact.problem)


def as_yaml(case: Case, client: Client, profiles: ProfileFiles) -> str:
    """Returns the case as YAML text. Raises click.UsageError for a case without parameters."""
    import yaml

    params = case_params(case, client, profiles)
    text: str = yaml.safe_dump(plain_json(params), sort_keys=False, default_flow_style=None, width=120)
    return f"# Case {case.number}, line {case.line}, {written_by()}.\n{text}"


def as_python(file: Path, cases: Sequence[Case], client: Client, profiles: ProfileFiles) -> str:
    """Returns a program that solves the cases one after the other."""
    contacts = [_made(case, client, profiles) for case in cases]
    return python_text(f"Cases of {file.name}, by contactd.", contacts, [goes_on(case) for case in cases])


def _made(case: Case, client: Client, profiles: ProfileFiles) -> BasicContact | RailContact | str:
    where = f"Case {case.number} in line {case.line}"
    if case.errors:
        return f"{where} cannot be read: {' '.join(case.errors)}"
    if found := mistakes(case):
        return f"{where} is wrong: {'; '.join(found)}."

    def normal_force(problem: ContactProblem) -> float:
        return client.solve(problem, fields=[]).Fn

    try:
        if case.module == 1:
            return RailContact.of(case, profiles, "exact")
        return BasicContact.of(case, normal_force, coefficients=profiles.coefficients)
    except Missing as error:
        return f"{where} requires a feature that contactd does not support: {error}."
    except TableFileError as error:
        raise click.UsageError(f"{where}: {error}.") from None
    except OSError as error:
        raise click.UsageError(f"{where}: {error.filename or 'a file that it names'} cannot be read: {error.strerror or error}.") from None

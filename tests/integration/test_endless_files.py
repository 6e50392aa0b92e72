"""Tests files of cases and of profiles with 2 MiB of one character: the service reads them immediately, and only
once."""

import pytest

from support.contact_cases import rail_case
from support.contact_runs import computed

SIZE = (2 << 20) - 200
CHARACTERS = {"blanks": " ", "line ends": "\n", "quotes": '"', "apostrophes": "'", "digits": "1", "tabs": "\t", "commas": ","}
HEADS = {"prr": "header.begin\n type = 0\nheader.end\nspline.begin\n", "ban": "", "txt": ""}


@pytest.mark.parametrize("character", CHARACTERS)
@pytest.mark.parametrize("ending", HEADS)
def test_a_case_with_such_a_profile_is_wrong(shared, tmp_path, ending, character):
    """Uses also a scale and a mirror, for which statements in the file matter."""
    (tmp_path / f"rail.{ending}").write_text(HEADS[ending] + SIZE * CHARACTERS[character])
    case = rail_case(RFNAME=f"rail.{ending}", RAIL_SCALE=1000.0, RAIL_MIRRORY=-1)
    (outcome,) = computed(shared, [case], tmp_path)
    assert outcome.status in ("wrong", "refused"), outcome.sentence
    assert 0 < len(outcome.sentence) < 1000


@pytest.mark.parametrize("character", CHARACTERS)
def test_such_a_file_of_cases_or_of_slices_has_none(shared, character):
    text = SIZE * CHARACTERS[character]
    assert shared.read_contact_file(text).cases == ()
    with pytest.raises(ValueError, match="line"):
        shared.read_contact_slices("0 1\n3\n0 0 0\n1\n" + text)

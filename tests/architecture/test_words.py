"""Names are the field's: files and identifiers of C++ have none of the words that the field says otherwise.

A folder more is a line of FOLDERS, a word more a line of WORDS. What a word rightly names stands in NAMES, or, where a
whole file speaks of something else, in FILES, each with its reason. `words.toml` would be the same with more to learn.
"""

import re
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ["core/src", "core/fem", "core/include", "engine"]

#: Parts of names in snake case, as regular expressions, and what the field says.
WORDS = {
    "turns?": "outer iteration, queue ticket, rotation",
    "turning": "tangent stiffness, angular velocity",
    "columns?": "strip",
    "prisms?": "longitudinally uniform body",
    "quick": "simplified (contact model)",
    "stop_test": "stopping criterion",
    "held": "clamped, frozen",
    "keeper": "cache",
    "tents?": "bilinear hat function",
    "wide": "SIMD",
    "doubts": "quality flags",
    "on_springs|give_way|rail_shift": "massless flexible rail, rail deflection",
    "place_with_gap|places|solve_place": "candidate patch, contact location",
    "want(?:s|ed)?|wheel_want": "request, output",
    "touch|pulling": "first_contact_height, solve_for_Fx",
    "bears|borne": "carries its load",
    "slip_beside": "additional slip",
    "patience": "timeout, most failures",
    "words?": "enumerator, keyword",
    "said|told|teller|statement|lay_over": "input, reported, overlay",
    "lender|outcomes|showing|labelled": "pool, results, representation, arrays",
}

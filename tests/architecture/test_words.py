"""Names and comments are the field's: they have none of the words that experts say otherwise.

Another folder is a line of FOLDERS, another word of names a line of WORDS, another expression one of
support/field_words.py. Where such a word is right, it stands with its reason in NAMES, as an identifier, or in FILES,
for all that a file names.
"""

import io
import re
import tokenize
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

import pytest

from support.field_words import everyday

ROOT = Path(__file__).parents[2]
#: Folders with C++, folders with C++ whose comments are held to it too, and folders with Python.
FOLDERS = ["core", "engine", "tests/core", "tests/engine"]
WITH_COMMENTS = [
    "server", "bench", "proto", "client/c", "client/cpp", "client/cntc", "client/fmu", "packaging", "tests/proto",
    "tests/server", "tests/verification", "tests/support", "tests/fuzz",
]  # fmt: skip
PYTHON = [
    "bench", "client/python", "docs", "packaging", "proto", "tests/integration", "tests/support", "tests/fuzz", "tests/load", "tests/conformance",
    "tests/bench", "tests/docs",
]  # fmt: skip
#: Whole words of a name in snake case, and what the field says.
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
    "in_wide|wide": "SIMD",
    "doubts": "quality flags",
    "on_springs|give_way|rail_shift": "massless flexible rail, rail deflection",
    "place_with_gap|solve_place": "candidate patch",
    "want(s|ed)?": "request, output",
    "touch|pulling": "first_contact_height, solve_for_Fx",
    "bears|borne": "carries its load",
    "slip_beside": "additional slip",
    "patience": "timeout, most failures",
    "words?": "enumerator, keyword",
    "said|told|teller|statement|lay_over": "input, reported, overlay",
    "lender|outcomes|showing|labelled": "pool, results, representation, arrays",
}
#: Identifiers with one of these words, but for an underscore at the end, and why.
NAMES = {
    "columns": "the field of the wire, and columns of matrices and grids",
    "ContactColumns": "the field `columns` of the wire",
    "contact_columns": "the field `columns` of the wire",
    "check_columns": "the field `columns` of the wire",
    "contact_columns_check": "the field `columns` of the wire",
    "column": "of a matrix or a grid",
    "Column": "of a table",
    "SparseColumns": "of a matrix",
    "multiply_columns": "of a matrix",
    "held": "locks",
    "distance_turn": "the field of the wire",
    "turn_neighbours": "the rule of `distance_turn`",
    "turn": "an angle or a revolution",
    "largest_turn": "an angle",
    "by_turn": "an angle",
    "turn_rate": "an angle over a length",
    "turn_step": "an angle",
    "turn_before": "an angle",
    "turn_cosine": "of an angle",
    "turn_sine": "of an angle",
    "most_strip_turn": "an angle",
    "quarter_turn": "an angle",
    "turn_axes": "a rotation",
    "turn_back": "a rotation of phases",
    "prism": "the keyword of the wire for a mesh of wedges",
    "SortColumnIndices": "MFEM's",
    "block_column": "of a table",
    "enum_words": "the keywords of the wire",
    "contactd_set_word": "of contactd.h",
    "contactd_get_word": "of contactd.h",
    "contactd_want": "of contactd.h",
    "HasWords": "the keywords of the wire",
}
#: Files that name something else with these words, and why.
FILES = {
    "core/src/fft/*": "columns of an array",
    "core/src/geometry/placement/rail_surface.*": "columns of a grid of heights",
    "core/src/geometry/search/*_mesh.*": "columns of a mesh",
    "core/src/geometry/search/mesh_search.cpp": "columns of a mesh",
    "core/src/operators/fft/padded_fft*": "columns of an array",
    "core/src/operators/strips/strip_kernels.*": "columns of a matrix",
    "core/src/operators/upstream.cpp": "columns of a grid",
    "core/fem/mesh/*": "prisms, the shape of finite elements",
    "core/fem/system/*": "prisms, the shape of finite elements",
    "core/include/contactd/fem_fields.hpp": "prisms, the shape of finite elements",
    "core/types/contact_files/*": "columns of a line, of an array and of elements",
    "core/types/profile_files/*": "columns of a file",
    "tests/core/fft/*": "columns of an array",
    "client/c/include/contactd/paths.h": "paths of the wire, and constants of keywords",
    "tests/core/contact_files/*": "words of a line",
    "tests/core/fem/*": "prisms, the shape of finite elements",
    "bench/import_time.py": "statements of Python",
    "client/python/contactctl/dashboard/*.py": "`said` of a Sample and `patience` of a Watcher, which tests name",
    "client/python/contactd/values/dictionaries.py": "`told`, the argument of the public from_dict",
    "packaging/wheels/import_time.py": "statements of Python",
    "bench/paper/fem/*": "prisms, the shape of finite elements",
    "tests/bench/paper/fem/*": "prisms, the shape of finite elements",
}
#: Those WORDS that have an ordinary meaning in scripts: arguments and texts, tables, pathlib's and those of `--quick`.
ORDINARY_IN_PYTHON = frozenset({"words?", "columns?", "touch|pulling", "quick"})
#: Files that quote everyday expressions, and why.
QUOTING = {
    "tests/docs/test_glossary.py": "an example of what not to write",
    "tests/integration/test_wheelset_roll.py": "a warning of core",
    "tests/support/field_words.py": "the expressions themselves",
}
NO_NAMES = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|^\s*\#\s*include[^\n]*""",
    re.DOTALL | re.MULTILINE,
)


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


@cache
def instead_of(name, ordinary=frozenset()):
    """What the field says for a word in `name`, or None."""
    return next(
        (
            term
            for word, term in WORDS.items()
            if word not in ordinary and re.search(rf"(?:^|_)(?:{word})(?:_|$)", snake(name))
        ),
        None,
    )


def files_of(folder, *suffixes):
    files = [path for path in sorted((ROOT / folder).rglob("*")) if path.suffix in suffixes]
    assert files, folder
    return files


def names_of_cpp(path):
    return {name for name in {path.stem, *re.findall(r"[A-Za-z_]\w*", NO_NAMES.sub(" ", path.read_text()))} if instead_of(name)}


def names_of_python(path):
    """But for tests, whose names are sentences."""
    tokens = tokenize.generate_tokens(io.StringIO(path.read_text()).readline)
    names = {path.stem, *(token.string for token in tokens if token.type == tokenize.NAME)}
    return {name for name in names if not name.startswith("test_") and instead_of(name, ORDINARY_IN_PYTHON)}


@cache
def everyday_names(folder):
    """The pairs of a file and a name with an everyday word, exceptions among them."""
    found = set()
    for folders, suffixes, names_of in (
        ([*FOLDERS, *WITH_COMMENTS], (".cpp", ".hpp", ".h"), names_of_cpp),
        (PYTHON, (".py",), names_of_python),
    ):
        if folder in folders:
            found |= {(str(path.relative_to(ROOT)), name) for path in files_of(folder, *suffixes) for name in names_of(path)}
    return found


def allowed_by_file(file):
    return [pattern for pattern in FILES if fnmatch(file, pattern)]


@pytest.mark.parametrize("folder", sorted({*FOLDERS, *WITH_COMMENTS, *PYTHON}))
def test_names_are_those_of_the_field(folder):
    wrong = {pair for pair in everyday_names(folder) if pair[1].rstrip("_") not in NAMES and not allowed_by_file(pair[0])}
    assert not wrong, "\n".join(f"{file}: {name}; the field says: {instead_of(name)}" for file, name in sorted(wrong))


@pytest.mark.parametrize("folder", sorted({*WITH_COMMENTS, *PYTHON}))
def test_comments_and_messages_are_those_of_the_field(folder):
    """Names of tests, too, which are sentences."""
    found = {}
    for path in files_of(folder, ".cpp", ".hpp", ".h", ".py"):
        text = re.sub(r"\btest_\w+", lambda name: name[0].replace("_", " "), path.read_text())
        if expressions := everyday(text):
            found[str(path.relative_to(ROOT))] = expressions
    assert not {file: expressions for file, expressions in found.items() if file not in QUOTING}


@pytest.mark.parametrize("folder", WITH_COMMENTS)
def test_comments_begin_as_sentences(folder):
    """With a subject, which is not left to the name below."""
    begin = re.compile(r"^(?!\s*//).*\n\s*(///? (?:Of|The same|As|What) .*)|\A(// (?:Of|The same|As|What) .*)", re.MULTILINE)
    found = [(path.name, match[0]) for path in files_of(folder, ".cpp", ".hpp", ".h") for match in begin.finditer(path.read_text())]
    assert not found


def test_each_exception_is_needed():
    pairs = set().union(*map(everyday_names, {*FOLDERS, *WITH_COMMENTS, *PYTHON}))
    assert not set(NAMES) - {name.rstrip("_") for _, name in pairs}
    needed = {pattern for file, name in pairs if name.rstrip("_") not in NAMES for pattern in allowed_by_file(file)}
    assert not set(FILES) - needed


@pytest.mark.parametrize(
    ("name", "term"),
    [
        ("TurningLevels", "tangent stiffness, angular velocity"),
        ("held_contact", "clamped, frozen"),
        ("PlaceWithGap", "candidate patch"),
        ("solve_on_springs", "massless flexible rail, rail deflection"),
        ("returns", None),
        ("potential", None),
        ("threshold", None),
    ],
)
def test_words_are_found_as_whole_ones(name, term):
    assert instead_of(name) == term

"""Tests that readers of 2 MiB of one character take time proportional to the text, not to its square, which would take
hours."""

import subprocess
import sys

import pytest

from support.slowness import SLOWER

SIZE = 2 << 20
TEXTS = {
    "blanks": "' ' * n", "line ends": "'\\n' * n", "quotes": "'\"' * n", "apostrophes": "chr(39) * n", "digits": "'1' * n",
    "digits before a letter": "'1' * n + 'x'", "letters between blanks": "'x' + ' ' * n + 'x'", "commas": "',' * n", "points": "'.' * n",
}  # fmt: skip
READERS = {
    "rows of numbers": "contactd.files.number_text:rows_of",
    "a table with names": "contactd.files.number_text:table_of",
    "coefficients": "contactd.files.contact_text:_number",
    "printed results": "contactd.contact_files.out_reader:printed_cases",
    "YAML": "contactctl.yaml_files:parse_yaml",
    "JSON": "contactctl.files:_json",
    "a path": "contactctl.paths:parts",
}
PROGRAM = """
import importlib, sys
n, (module, name) = int(sys.argv[1]), sys.argv[2].split(":")
read = getattr(importlib.import_module(module), name)
for text in sys.argv[3:]:
    try:
        read(eval(text), *([list] if name == "parse_yaml" else []))
    except Exception as error:
        assert len(str(error)) < 1000, str(error)[:300]
"""


@pytest.mark.parametrize("reader", READERS)
def test_what_reads_text_takes_two_mebibytes_of_one_character(reader):
    """Runs it in a process, which can be ended even if a library holds the interpreter's lock."""
    command = [sys.executable, "-c", PROGRAM, str(SIZE), READERS[reader], *TEXTS.values()]
    environment = {"PYTHONPATH": ":".join(path for path in sys.path if path)}
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=50 * SLOWER)
    assert ended.returncode == 0, ended.stderr

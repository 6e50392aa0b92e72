"""The examples of docs/ic-tables.md run as they stand there."""

import re
from pathlib import Path

import pytest

GUIDE = (Path(__file__).parents[2] / "docs" / "ic-tables.md").read_text()
EXAMPLES = re.findall(r"^```python\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)


@pytest.mark.time_limit(300)
def test_the_examples_of_the_guide_run_one_after_the_other(shared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where an example writes files
    names = {"client": shared}
    assert len(EXAMPLES) >= 8
    for example in EXAMPLES:
        exec(compile(example, f"docs/ic-tables.md: {example.splitlines()[0]}", "exec"), names)
    assert names["evidence"].warnings[0].startswith("L_over_h is 40")

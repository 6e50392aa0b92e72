"""The examples of the guides run as they stand there."""

import re
from pathlib import Path
from typing import Any

import pytest

DOCS = Path(__file__).parents[2] / "docs"


def run_examples(guide: str, client: Any) -> dict[str, Any]:
    """One after the other; what they leave behind."""
    names = {"client": client}
    examples = re.findall(r"^```python\n(.*?)^```", (DOCS / guide).read_text(), re.MULTILINE | re.DOTALL)
    assert len(examples) >= 4
    for example in examples:
        exec(compile(example, f"docs/{guide}: {example.splitlines()[0]}", "exec"), names)
    return names


@pytest.mark.time_limit(300)
def test_the_guide_to_tables(shared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where an example writes files
    assert run_examples("ic-tables.md", shared)["evidence"].warnings[0].startswith("L_over_h is 40")


def test_the_guide_to_sessions(shared):
    assert run_examples("sessions.md", shared)["contact"].Fx < -5000
    assert not shared.sessions()


def test_the_guide_to_contact_problems(shared):
    names = run_examples("contact.md", shared)
    assert abs(names["force"] / names["expected"] - 1).max() < 0.02
    assert names["pulled"].approach == pytest.approx(0.02, rel=1e-6)
    assert names["free"].motion.eta < 0

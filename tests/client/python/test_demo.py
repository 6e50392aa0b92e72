"""Tests the demo as a new user starts it."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

pytest.importorskip("matplotlib")

HERE = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
DEMO = [sys.executable, "-m", "contactd.demo"]


def test_a_picture_is_drawn_into_a_name_with_blanks(tmp_path):
    ended = subprocess.run([*DEMO, "a \u00e4.png"], cwd=tmp_path, env=HERE, capture_output=True, text=True, check=False)
    assert ended.returncode == 0 and "The picture: a \u00e4.png" in ended.stdout
    assert (tmp_path / "a \u00e4.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(("picture", "sentence"), [("a.foo", "must end in .png, .pdf, .svg"), (".", "must end in .png"), ("file/a.png", "The demo failed.")])
def test_a_picture_that_cannot_be_is_told_in_a_sentence(tmp_path, picture, sentence):
    (tmp_path / "file").touch()
    ended = subprocess.run([*DEMO, picture], cwd=tmp_path, env=HERE, capture_output=True, text=True, check=False)
    assert ended.returncode == 2 and sentence in ended.stderr and "Traceback" not in ended.stderr


def test_a_reader_that_has_gone_is_no_failure_of_its_own(tmp_path):
    ended = subprocess.run(["bash", "-c", 'set -o pipefail; "$@" | true', "bash", *DEMO, "a.png"], cwd=tmp_path, env=HERE, capture_output=True, text=True, check=False)
    assert ended.returncode in (0, 141) and "Traceback" not in ended.stderr

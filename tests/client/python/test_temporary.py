"""Tests temporary folders: each is removed with its process, or by the next process if that was killed."""

import os
import subprocess
import sys
from pathlib import Path

from contactd.transport.temporary import TemporaryFolder

MAKES_ONE = """
import sys
from contactd.transport.temporary import TemporaryFolder
made = TemporaryFolder(sys.argv[1])
print(made.path, flush=True)
sys.stdin.read()
"""


def other(tmp_path):
    """Provides another process with a folder, and its path."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    process = subprocess.Popen([sys.executable, "-c", MAKES_ONE, str(tmp_path)], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    return process, Path(process.stdout.readline().strip())


def test_a_folder_is_removed_with_what_is_in_it(tmp_path):
    made = TemporaryFolder(str(tmp_path))
    (made.path / "store").mkdir()
    made.remove()
    made.remove()
    assert list(tmp_path.iterdir()) == []


def test_the_folder_of_a_process_that_was_killed_is_swept_and_no_other(tmp_path):
    for foreign in ("contactd-notes", "others-folder"):
        (tmp_path / foreign).mkdir()
    (tmp_path / "contactd-link").symlink_to(tmp_path / "others-folder")
    killed, left = other(tmp_path)
    alive, kept = other(tmp_path)
    with killed, alive:
        killed.kill()
        killed.wait()
        assert left.is_dir()
        made = TemporaryFolder(str(tmp_path))
        assert not left.exists()
        assert kept.is_dir()
        made.remove()
        alive.stdin.close()
    assert {path.name for path in tmp_path.iterdir()} >= {"contactd-notes", "others-folder", "contactd-link"}

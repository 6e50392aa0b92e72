"""Tests progress=True: a bar in addition to on_progress."""

import subprocess
import sys

import pytest

from contactd import AnalyticIcs, Client, Grid, Material, MissingExtra
from support import answers
from support.fake_server import FakeServer

STEEL, GRID = Material(82000, 0.28), Grid(3, 2, 1, 1)


@pytest.fixture
def client(tmp_path):
    def script(request):
        going = [request.progress(stage="pcg", fraction=f, iteration=3, residual=1e-3, seconds_left=9) for f in (0.2, 0.4)]
        return [*going, request.result(*answers.table(2, 3))] if request.method == "ic.get" else [request.failure(5, "No.")]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        yield client


def test_a_bar_shows_what_is_done(client, capsys):
    pytest.importorskip("rich")
    seen = []
    client.get_ic(STEEL, GRID, AnalyticIcs(), progress=True, on_progress=seen.append)
    assert len(seen) == 2
    shown = capsys.readouterr().out
    assert "ic.get" in shown
    assert "100 %" in shown


def test_no_bar_is_left_where_the_call_fails(client):
    pytest.importorskip("rich")
    for _ in range(2):  # a second bar is refused while one is shown
        with pytest.raises(Exception, match="No"):
            client.call("contact.solve", progress=True)


def test_without_rich_it_is_said_what_to_install(client, monkeypatch):
    monkeypatch.setitem(sys.modules, "rich.progress", None)
    with pytest.raises(MissingExtra, match=r'progress=True needs rich: pip install "contactd\[progress\]"'):
        client.get_ic(STEEL, GRID, AnalyticIcs(), progress=True)


def test_a_client_needs_numpy_and_pyzmq_only():
    code = "import sys, contactd; left = {'rich', 'h5py', 'xarray', 'matplotlib', 'asyncio', 'typing_extensions'} & set(sys.modules); assert not left, left"
    subprocess.run([sys.executable, "-c", code], check=True)

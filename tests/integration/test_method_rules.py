"""Tests methods that the configuration disables or restricts to some users, in every way to call them."""

import os
import subprocess

import pytest

from contactd import AnalyticIcs, InvalidArgument, PermissionDenied, Unimplemented
from contactd.wheel_rail import WheelRailFriction, WheelRailSetup, WheelRailState, WheelsetPosition
from support.daemons import BIN, eventually
from support.fortress import Fortress
from support.problems import CATTANEO, ENDLESS, GRID, LONG, QUICK, STEEL

ME = f"uid:{os.getuid()}"


def test_a_method_that_is_switched_off_says_so(daemons):
    daemon = daemons.start(methods={"disabled": ["ic.delete", "server.metrics"]})
    with daemon.client() as client:
        for ask in (lambda: client.delete_ic("0" * 64), client.metrics):
            with pytest.raises(Unimplemented, match=r"disabled by the configuration of this daemon \(methods\.disabled\)") as caught:
                ask()
            assert caught.value.reason == "METHOD_DISABLED"
        assert client.solve(CATTANEO).converged
        assert client.config()["methods"] == {"disabled": ["ic.delete", "server.metrics"], "allowed_users": {}}
        marked = {method["name"] for method in client.describe()["methods"] if method.get("x-disabled")}
        assert marked == {"ic.delete", "server.metrics"}


def test_a_method_is_for_those_to_whom_it_is_given(daemons):
    with daemons.start(methods={"allowed_users": {"ic.delete": ["uid:1"], "job.cancel": [ME]}}).client() as client:
        with pytest.raises(PermissionDenied, match=f'"{ME}" is not among them') as caught:
            client.delete_ic("0" * 64)
        assert caught.value.reason == "METHOD_DENIED"
        with pytest.raises(Exception, match="There is no job"):
            client.cancel_job("build-1")
        marked = {method["name"] for method in client.describe()["methods"] if method.get("x-denied")}
        assert marked == {"ic.delete"}


def test_users_are_the_names_of_their_keys(daemons, tmp_path):
    fortress = Fortress(daemons, tmp_path, methods={"allowed_users": {"ic.import": ["bob"], "builds": ["bob"]}})
    bob = fortress.make_user("bob")
    fortress.allow("bob")
    fortress.reload()
    with fortress.client() as alice, fortress.client(own_key=bob) as client:
        closed_form = client.export_ic(STEEL, GRID, AnalyticIcs())
        with pytest.raises(PermissionDenied):
            alice.import_ic(closed_form)
        with pytest.raises(InvalidArgument, match="analytic"):
            client.import_ic(closed_form)
        with pytest.raises(PermissionDenied):
            alice.get_ic(STEEL, GRID, QUICK)
        table = client.get_ic(STEEL, GRID, QUICK)
        assert (alice.get_ic(STEEL, GRID, QUICK).array == table.array).all()


def test_builds_are_for_those_to_whom_they_are_given_whatever_asks_for_them(daemons):
    with daemons.start(methods={"allowed_users": {"builds": []}}).client() as client:
        problem = CATTANEO.replace(grid=GRID, upper=STEEL, ics=QUICK)
        for ask in (
            lambda: client.get_ic(STEEL, GRID, QUICK),
            lambda: client.export_ic(STEEL, GRID, QUICK),
            lambda: client.solve(problem),
            lambda: client.session(problem),
        ):
            with pytest.raises(PermissionDenied, match="you are not among the users who may build tables") as caught:
                ask()
            assert caught.value.reason == "BUILD_DENIED"
        (answer,) = client.solve_many([problem])
        assert answer.reason == "BUILD_DENIED"
        assert client.info().counters["builds_started"] == 0
        assert client.solve(CATTANEO).converged  # of a closed form


def test_a_wheel_on_its_rail_has_nothing_built_for_who_may_not(daemons):
    setup = WheelRailSetup(dx=0.6, dy=0.6, conformal="fem", friction=WheelRailFriction(mu=0.3))
    state = WheelRailState(position=WheelsetPosition(), Fz=80e3)
    with daemons.start(methods={"allowed_users": {"builds": ["uid:1"]}}).client() as client:
        with pytest.raises(PermissionDenied) as caught:
            client.wheel_rail(setup, state, fields=[])
        assert caught.value.reason == "BUILD_DENIED"
        assert client.info().counters["builds_started"] == 0


def test_a_job_says_whose_it_is_and_what(client, background):
    waiting = [background(client.get_ic, STEEL, GRID, LONG), background(client.solve, ENDLESS)]
    eventually(lambda: sorted(job.kind for job in client.jobs()) == ["build", "solve"])
    build, solve = sorted(client.jobs(), key=lambda job: job.kind)
    assert build.users == solve.users == (ME,)
    assert build.description == "finite elements, a half-space of nu 0.28: 6 x 6 offsets of 0.8 x 0.8 mm"
    assert solve.description == "contact.solve, 320 x 320 elements"
    for job in (build, solve):
        client.cancel_job(job.job)
    assert [call.exception(30).name for call in waiting] == ["CANCELLED"] * 2


@pytest.mark.parametrize(
    ("methods", "sentence"),
    [
        ('{"disabled": ["ic.imprt"]}', 'methods.disabled[0] is "ic.imprt", which is not a method'),
        ('{"allowed_users": {"build": ["alice"]}}', 'methods.allowed_users is "build", which is not a method'),
        ('{"allowed_users": {"builds": ["uid:me"]}}', "methods.allowed_users"),
    ],
)
def test_a_daemon_with_a_misspelt_name_does_not_start(tmp_path, methods, sentence):
    (tmp_path / "config.json").write_text(f'{{"endpoint": "ipc://{tmp_path}/s", "methods": {methods}}}')
    for words in ([], ["--check-config"]):
        ended = subprocess.run(
            [BIN / "contactd", "--config", tmp_path / "config.json", *words], capture_output=True, text=True, timeout=20
        )
        assert ended.returncode != 0
        assert sentence in ended.stderr

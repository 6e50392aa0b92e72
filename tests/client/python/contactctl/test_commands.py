"""Tests every command, with output for users and for scripts."""

import numpy as np
import pytest
import zmq.auth

from contactd import Client, load, load_table

HISTORY = """\
open:
  grid: {nx: 15, ny: 15, dx: 0.93, dy: 0.93}
  bodies: {upper: {G: 82000, nu: 0.28}}
  ics: {source: analytic}
  gap: {paraboloid: {Rx: 460, Ry: 300}}
  friction: {mu: 0.3, rolling: {}}
steps: [{Fn: 50e3, friction: {rolling: {xi: 5e-4}}}, {Fn: 60e3, friction: {rolling: {xi: 1e-3}}}]
"""
COARSE = ("--set", "setup.dx=0.8", "--set", "setup.dy=0.8")


def test_info_tells_what_the_daemon_tells(ctl):
    said = ctl("info", "--json")
    with Client(ctl.endpoint) as client:
        info = client.info()
    assert (said.code, said.err) == (0, "")
    assert (said.json["version"], said.json["limits"]["max_queue"]) == (info.version, info.limits.max_queue)
    shown = ctl("info")
    assert ctl.endpoint in shown.out
    assert "zeromq" in shown.out


def test_health_says_whether_the_daemon_serves(ctl):
    assert ctl("health").out == "serving\n"
    assert ctl("health", "--json").json == {"state": "serving", "warnings": []}


def test_a_solve_has_the_same_answer_as_the_client_to_the_last_bit(ctl):
    said = ctl("solve", "contact.yaml", "--json")
    params = {"grid": {"nx": 20, "ny": 20, "dx": 0.12, "dy": 0.12}, "bodies": {"upper": {"G": 200, "nu": 0.42}},
              "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 50, "Ry": 50}}, "approach": 0.02,
              "friction": {"mu": 0.4, "rigid_shift": [0.00817, 0]}}  # fmt: skip
    with Client(ctl.endpoint) as client:
        answer = client.call("contact.solve", params)
    assert said.json["forces"] == answer["forces"]
    assert np.array_equal(said.json["traction_x"], answer["traction_x"])


def test_a_solve_for_people_has_names_units_and_aligned_values(ctl):
    lines = ctl("solve", "contact.yaml").out.splitlines()
    assert lines[0] == "Contact on 20 x 20 elements of 0.12 x 0.12 mm"
    starts = {len(name) for name in (line[: line.rindex("   ") + 3] for line in lines[1:])}
    assert len(starts) == 1, "values do not begin in one column"
    assert any(line.startswith("pmax (N/mm^2)") for line in lines)
    assert not [line for line in lines if line != line.rstrip()]


def test_a_problem_is_read_from_standard_input_and_changed_by_set(ctl):
    text = (ctl.folder / "contact.yaml").read_text()
    first = ctl("solve", "-", "--json", "--set", "friction.mu=0.05", "--fields", "none", given=text).json
    assert abs(first["forces"]["Fx"]) == pytest.approx(0.05 * first["forces"]["Fn"], rel=1e-3), "all slips"
    assert "pressure" not in first


def test_answers_go_to_files_by_their_endings(ctl):
    said = ctl("solve", "contact.yaml", "--json", "-o", "a.json", "-o", "a.h5", "-o", "a.png", "-o", "a.svg")
    assert (ctl.folder / "a.json").read_text() == said.out
    solution = load(ctl.folder / "a.h5")
    assert np.array_equal(solution.pressure, said.json["pressure"])
    assert solution.Fn == said.json["forces"]["Fn"]
    assert (ctl.folder / "a.png").read_bytes().startswith(b"\x89PNG")
    assert "</svg>" in (ctl.folder / "a.svg").read_text()
    assert not list(ctl.folder.glob("*.part"))


def test_an_array_lies_in_a_file_of_its_own(ctl):
    x = (np.arange(20) - 9.5) * 0.12
    np.save(ctl.folder / "gap.npy", (x[:, None] ** 2 + x**2) / 100)
    np.savetxt(ctl.folder / "gap.csv", (x[:, None] ** 2 + x**2) / 100, delimiter=",")
    text = (ctl.folder / "contact.yaml").read_text()
    expected = ctl("solve", "contact.yaml", "--json").json["forces"]["Fn"]
    for name in ("gap.npy", "gap.csv"):
        ctl.write("own.yaml", text.replace("{paraboloid: {Rx: 50, Ry: 50}}", f"{{array: {{$file: {name}}}}}"))
        assert ctl("solve", "own.yaml", "--json").json["forces"]["Fn"] == pytest.approx(expected, rel=1e-9)


def test_a_wheel_stands_on_its_rail_with_the_force_that_was_asked_for(ctl):
    words = ("--y", 3, "--yaw", 0.002, "--Fz", 80e3, "--speed", 20e3, *COARSE)
    said = ctl("wheelrail", "solve", *words, "--json").json
    assert said["forces"]["track"]["Fz"] == pytest.approx(80e3, rel=1e-5)
    assert said["pitch_rate"] == pytest.approx(-20e3 / 460)
    shown = ctl("wheelrail", "solve", *words, "-o", "patches.png")
    assert "Patches" in shown.out
    assert (ctl.folder / "patches.png").exists()
    assert ctl("wheelrail", "solve", *words, "-o", "patches.h5").code == 0
    assert load(ctl.folder / "patches.h5").forces.track.Fz == said["forces"]["track"]["Fz"]
    other = ctl("wheelrail", "solve", "--y", -3, "--yaw", -0.002, "--Fz", 80e3, "--speed", 20e3, "--side", "left", *COARSE, "--json").json
    assert other["forces"]["track"]["Fy"] == pytest.approx(-said["forces"]["track"]["Fy"], rel=1e-6)


def test_options_of_a_wheel_are_laid_over_its_file(ctl):
    ctl.write("wheel.yaml", "setup: {dx: 0.8, dy: 0.8}\nstate: {Fz: 60e3, position: {y: 1}}\n")
    said = ctl("wheelrail", "geometry", "wheel.yaml", "--json").json["geometries"][0]
    other = ctl("wheelrail", "geometry", "wheel.yaml", "--y", 5, "--json").json["geometries"][0]
    same = ctl("wheelrail", "geometry", "--y", 1, "--Fz", 60e3, *COARSE, "--json").json["geometries"][0]
    assert said["places"][0]["reference"] == same["places"][0]["reference"] != other["places"][0]["reference"]
    assert "angle (deg)" in ctl("wheelrail", "geometry", "wheel.yaml").out


def test_equivalent_conicity_is_a_geometry(ctl):
    ctl.write("conicity.yaml", "conicity: {amplitudes: [3]}\n")
    assert ctl("wheelrail", "geometry", "conicity.yaml", "--json").json["conicities"][0]["amplitude"] == 3
    assert "integrated" in ctl("wheelrail", "geometry", "conicity.yaml").out


def test_a_history_is_replayed_step_by_step(ctl):
    ctl.write("history.yaml", HISTORY)
    steps = ctl("session", "history.yaml", "--json").json["steps"]
    assert [step["step"] for step in steps] == [1, 2]
    assert steps[1]["forces"]["Fx"] < steps[0]["forces"]["Fx"] < 0
    with Client(ctl.endpoint) as client:
        assert not client.sessions(), "a session was left open"
    assert len(ctl("session", "history.yaml").out.splitlines()) == 4


def test_the_steps_of_a_history_come_from_a_csv_file(ctl):
    ctl.write("history.yaml", HISTORY)
    ctl.write("csv.yaml", HISTORY.partition("steps:")[0] + "steps: steps.csv\n")
    ctl.write("steps.csv", "Fn,friction.rolling.xi\n50e3,5e-4\n60e3,1e-3\n")
    forces = [[step["forces"] for step in ctl("session", name, "--json").json["steps"]] for name in ("history.yaml", "csv.yaml")]
    assert forces[0] == forces[1]


def test_a_table_is_built_listed_shown_and_deleted(own):
    built = own("ic", "build", "quick.json", "--json")
    assert (built.code, built.json["origin"]) == (0, "built")
    assert "offsets" in built.err
    key = built.json["key"]
    assert own("ic", "build", "quick.json", "--json").json["origin"] == "memory"
    assert key in own("ic", "build", "quick.json").out
    assert [table["key"] for table in own("ic", "list", "--json").json["tables"]] == [key]
    assert key[:16] in own("ic", "list").out
    assert own("ic", "show", key[:8], "--json").json["key"] == key
    assert own("ic", "delete", key[:8]).out == "1 table deleted\n"
    assert own("ic", "list").out == "the store is empty\n"


def test_a_table_is_told_by_options_alone(own):
    words = ("--E", 210000, "--nu", 0.28, "--nx", 6, "--dx", 0.8, "--accuracy", 0.05)
    spec = own("ic", "build", *words, "--json").json["spec"]
    assert spec["grid"] == {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8}
    assert spec["material"]["G"] == pytest.approx(210000 / 2.56)


def test_a_table_is_exported_for_other_programs(own):
    for name in ("table.h5", "table.npz", "table.txt"):
        assert own("ic", "export", "quick.json", "-o", name, "--json").json["bytes"] == (own.folder / name).stat().st_size
    own_table, other = (load_table(own.folder / name) for name in ("table.h5", "table.npz"))
    assert np.array_equal(own_table.array, other.array)
    shown = own("ic", "show", "table.h5")
    assert "G = 82000" in shown.out
    assert own("ic", "show", "table.txt", "--json").json["of"] == "pair"


def test_a_table_of_another_store_is_imported(own, daemons):
    key = own("ic", "build", "quick.json", "--json").json["key"]
    other = daemons.start("other")
    (file,) = (other.folder.parent / "daemon" / "store").glob("*.h5")
    assert own("ic", "import", file, "--store", other.store, "--json").json["tables"] == [{"key": key, "nx": 6, "ny": 6, "new": True}]
    assert own("ic", "build", "quick.json", "-e", other.endpoint, "--json").json["origin"] == "disk"
    assert "was there" in own("ic", "import", file, "--store", other.store).out


UNIFORM = {"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 3, "ny": 4, "dx": 1, "dy": 1},
         "ics": {"source": "fem", "body": "longitudinally_uniform", "accuracy": 1e-2, "section": {"slab": {"thickness": 4, "width": 30}}}}  # fmt: skip
FAMILY = {**UNIFORM, "grid": {"nx": 3, "ny": 3, "dx": 1, "dy": 1}, "ics": {"source": "fem", "accuracy": 1e-2, "any_nu": True}}


@pytest.mark.parametrize(("request_", "extent"), [(UNIFORM, (1_000_000, 4)), (FAMILY, (3, 3))], ids=["uniform", "family"])
def test_longitudinally_uniform_bodies_and_families_of_another_store_are_imported(own, daemons, request_, extent):
    own.write("request.json", request_)
    key = own("ic", "build", "request.json", "--json").json["key"]
    other = daemons.start("other", builds={"program": "/bin/false"})
    (file,) = (other.folder.parent / "daemon" / "store").glob("*.h5")
    said = own("ic", "import", file, "--store", other.store, "--json").json["tables"]
    assert said == [{"key": key, "nx": extent[0], "ny": extent[1], "new": True}]
    assert own("ic", "build", "request.json", "-e", other.endpoint, "--json").json["origin"] == "disk"


def test_what_a_store_does_not_hold_is_not_put_into_it(own, daemons):
    own.write("uniform.json", UNIFORM)
    own("ic", "export", "uniform.json", "-o", "uniform.h5")
    folder, daemon_store = own.folder / "theirs", daemons.start("other").folder.parent / "daemon" / "store"
    folder.mkdir()
    (file,) = daemon_store.glob("*.h5")
    wrong = {file.name: (own.folder / "uniform.h5", "as written by ic.export"), file.name.replace("x4.", "x5."): (file, "its name states 1000000 x 5")}
    for name, (content, words) in wrong.items():
        own.folder.joinpath(name).write_bytes(content.read_bytes())
        refused = own("ic", "import", name, "--store", folder)
        assert refused.code == 2
        assert words in " ".join(refused.err.split())
    assert not list(folder.iterdir())


def test_an_exported_longitudinally_uniform_body_is_imported_and_shown(own, daemons):
    own.write("edge.json", UNIFORM)
    own("ic", "export", "edge.json", "-o", "edge.h5")
    assert "3 x 4 of 1 x 1 mm" in own("ic", "show", "edge.h5").out
    own("ic", "export", "edge.json", "-o", "edge.npz")
    assert load_table(own.folder / "edge.npz").frames.shape == (4, 3)
    other = daemons.start("other", builds={"program": "/bin/false"})
    (entry,) = own("ic", "import", "edge.h5", "-e", other.endpoint, "--json").json["tables"]
    assert entry["new"]
    assert own("ic", "build", "edge.json", "-e", other.endpoint, "--json").json["key"] == entry["key"]
    assert "was there" in own("ic", "import", "edge.h5", "-e", other.endpoint).out


def test_a_table_without_room_in_a_message_is_built_all_the_same(ctl):
    ctl.write("large.json", {"material": {"G": 1, "nu": 0.3}, "grid": {"nx": 1000, "ny": 900, "dx": 1, "dy": 1}, "ics": {"source": "analytic"}})
    assert "64.8 MB" in ctl("ic", "build", "large.json").err


def test_jobs_are_shown_and_cancelled(own):
    assert own("jobs").out == "no jobs\n"
    with own.start("solve", "endless.json") as waiting:
        while not (jobs := own("jobs", "--json").json["jobs"]):
            assert waiting.poll() is None
        assert jobs[0]["kind"] == "solve"
        assert jobs[0]["job"] in own("jobs").out
        assert own("cancel", jobs[0]["job"]).out == f"cancelled: {jobs[0]['job']}\n"
        _, err = waiting.communicate(timeout=30)
    assert waiting.returncode == 6
    assert "CANCELLED" in err
    assert own("cancel", "--all", "--json").json == {"cancelled": []}


def test_a_watch_has_a_line_or_an_object_for_each_look(ctl):
    import json

    lines = ctl("watch", "-n", 2, "-i", 0.1).out.splitlines()
    assert len(lines) == 2
    assert "requests/s" in lines[0]
    looks = [json.loads(line) for line in ctl("watch", "-n", 2, "-i", 0.1, "--json").out.splitlines()]
    assert [look["workers_busy"] for look in looks] == [0, 0]


def test_a_bench_measures_what_it_was_asked_to(ctl):
    said = ctl("bench", "-n", 20, "-c", 3, "--json").json
    assert said["requests"].keys() == {"server.health", "contact.solve"}
    for found in said["requests"].values():
        assert 0 < found["p50"] <= found["p90"] <= found["p99"] <= found["max"]
    assert "contact.solve" in ctl("bench", "contact.yaml", "-n", 5).out


def test_keys_are_made_once_and_never_shown(lonely):
    made = lonely("keys", "new", "alice", "--to", "keys", "--json").json
    secret = lonely.folder / made["secret"]
    assert secret.stat().st_mode & 0o777 == 0o600
    public, key = zmq.auth.load_certificate(secret)
    assert public.decode() == made["public_key"]
    assert key is not None
    shown = lonely("keys", "show", made["secret"])
    assert made["public_key"] in shown.out
    assert key.decode() not in shown.out
    assert lonely("keys", "new", "alice", "--to", "keys").code == 2
    secret.chmod(0o644)
    assert "chmod 600" in lonely("keys", "show", made["secret"]).out


def test_keys_open_an_encrypted_daemon(lonely, daemons):
    for name, folder in (("server", "keys"), ("alice", "keys/allowed")):
        lonely("keys", "new", name, "--to", folder)
    curve = {"secret_key_file": str(lonely.folder / "keys" / "server.key_secret"), "allowed_keys": str(lonely.folder / "keys" / "allowed")}
    daemon = daemons.start(security={"curve": curve})
    keys = {"CONTACTD_SERVER_KEY": "keys/server.key", "CONTACTD_OWN_KEY": "keys/allowed/alice.key_secret"}
    assert lonely("health", "-e", daemon.endpoint, **keys).out == "serving\n"
    assert lonely("health", "-e", daemon.endpoint).code == 3
    assert "own_key is missing" in lonely("health", "--server-key", "keys/server.key").err


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_is_a_script(lonely, shell):
    assert "_CONTACTCTL_COMPLETE" in lonely("completion", shell).out


def test_commands_and_options_are_completed(lonely):
    said = lonely(COMP_WORDS="contactctl ic bu", COMP_CWORD="2", _CONTACTCTL_COMPLETE="bash_complete")
    assert said.out == "plain,build\n"
    said = lonely(COMP_WORDS="contactctl solve --js", COMP_CWORD="2", _CONTACTCTL_COMPLETE="bash_complete")
    assert said.out == "plain,--json\n"


@pytest.mark.parametrize("installed", [True, False], ids=["in process", "daemon"])
def test_without_a_daemon_it_solves_by_itself(ctl, lonely, installed):
    expected = ctl("solve", "contact.yaml", "--json").json["forces"]
    hidden = {} if installed else {"PYTHONPATH": f"{lonely.write_module('contactd_local')}:{lonely.environment['PYTHONPATH']}"}
    said = lonely.alone("solve", "contact.yaml", "--local", "--json", **hidden)
    assert said.json["forces"] == expected


def test_a_local_table_is_kept_in_its_folder(lonely):
    words = ("ic", "build", "quick.json", "--local", "--folder", "tables", "--json")
    assert [lonely(*words).json["origin"] for _ in range(2)] == ["built", "disk"]
    assert lonely("ic", "list").code == 3

"""Tests ./dev outside of Debian 13: its questions, and the contents of its root. The programs it calls are
replaced."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
#: Programs of the system that ./dev itself runs.
ORDINARY = (
    "awk", "bash", "cat", "cut", "dirname", "env", "flock", "grep", "mkdir", "mktemp", "mv", "paste", "readlink", "rm", "sed",
    "sha256sum", "sort", "tail", "tar", "touch",
)  # fmt: skip
STANDINS = {
    "id": 'case $1 in -u) echo 1000 ;; -un) echo newcomer ;; esac',
    "apt-get": "exit 0",
    "dpkg-query": "exit 1",
    "mmdebstrap": 'printf "%s\\n" "$@" >>"$MAKER_LOG"; tar -c -T /dev/null',
    "bwrap": 'printf "%s\\n" "$@" >"$BWRAP_LOG"',
}


class Machine:
    """Provides a machine on which a user calls ./dev for the first time."""

    def __init__(self, folder: Path) -> None:
        self.programs, self.home, self.work = folder / "bin", folder / "home", folder / "work"
        self.binds, self.made = folder / "bwrap.log", folder / "mmdebstrap.log"
        for made in (self.programs, self.home, self.work):
            made.mkdir()
        for name in ORDINARY:
            (found,) = [p for p in (Path("/usr/bin") / name, Path("/bin") / name) if p.exists()][:1]
            (self.programs / name).symlink_to(found)
        for name, script in STANDINS.items():
            self.has(name, script)
        self.environment = {
            "PATH": str(self.programs), "HOME": str(self.home), "CONTACTD_DEV": "root", "BWRAP_LOG": str(self.binds),
            "MAKER_LOG": str(self.made), "CONTACTD_MIRROR": "http://nowhere.invalid",
        }  # fmt: skip

    def has(self, name: str, script: str = "exit 0") -> None:
        path = self.programs / name
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)

    def lacks(self, name: str) -> None:
        (self.programs / name).unlink()

    def dev(self, *arguments: str, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [ROOT / "dev", *arguments],
            cwd=folder or self.work, env=self.environment, capture_output=True, text=True, timeout=50,
        )  # fmt: skip

    def entered(self, *arguments: str, folder: Path | None = None) -> list[str]:
        """Returns the arguments of bwrap; there is a range of ids, and a root is made."""
        self.has("id", "echo 0")
        ended = self.dev(*arguments, folder=folder)
        assert ended.returncode == 0, ended.stderr
        return self.binds.read_text().splitlines()

    def roots(self) -> list[set[str]]:
        """Returns the packages of each root that was made."""
        words = self.made.read_text().splitlines() if self.made.exists() else []
        return [set(word.removeprefix("--include=").split(",")) for word in words if word.startswith("--include=")]

    def built(self, *arguments: str) -> list[str]:
        """Returns the arguments of CMake, one line per call, for the command in a checkout of this script alone."""
        checkout = self.work / "checkout"
        if not checkout.exists():
            shutil.copytree(ROOT / "packaging", checkout / "packaging")
            shutil.copy(ROOT / "dev", checkout)
        self.environment |= {"CONTACTD_INSIDE": "1", "CONTACTD_DUCC0": str(checkout), "MAKER_LOG": str(checkout / "cmake.log")}
        self.has("cmake", 'echo "$@" >>"$MAKER_LOG"')
        self.has("python3")
        subprocess.run([checkout / "dev", *arguments], env=self.environment, capture_output=True, timeout=50)
        lines = (checkout / "cmake.log").read_text().splitlines()
        (checkout / "cmake.log").unlink()
        return lines


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


def bound(words: list[str]) -> list[str]:
    """Returns folders that are bound at their own path."""
    pairs = [(words[i + 1], words[i + 2]) for i, word in enumerate(words) if word == "--bind"]
    return [source for source, place in pairs if source == place]


def setting(words: list[str], name: str) -> str:
    (value,) = [words[i + 2] for i, word in enumerate(words) if word == "--setenv" and words[i + 1] == name]
    return value


def test_an_ordinary_user_without_uidmap_is_told_what_to_install(machine):
    ended = machine.dev("shell", "true")
    assert ended.returncode == 1
    assert ended.stderr == "dev: packages are missing; run: sudo apt-get install --no-install-recommends uidmap\n"


@pytest.mark.parametrize(("program", "package"), [("mmdebstrap", "mmdebstrap"), ("bwrap", "bubblewrap")])
def test_a_missing_program_is_named_by_its_package(machine, program, package):
    machine.has("newuidmap")
    machine.lacks(program)
    assert f"--no-install-recommends {package}\n" in machine.dev("shell", "true").stderr


def test_a_system_without_apt_is_told_the_packages_too(machine):
    machine.lacks("apt-get")
    machine.lacks("bwrap")
    text = machine.dev("shell", "true").stderr
    assert text == "dev: this system needs bubblewrap uidmap (Debian's names); install them with its package manager\n"


def test_an_ordinary_user_without_a_range_of_ids_is_told_the_command(machine):
    machine.has("newuidmap")
    text = machine.dev("shell", "true").stderr
    found = re.search(r"run: sudo usermod --add-subuids (\d+)-(\d+) --add-subgids (\d+)-(\d+) newcomer$", text)
    assert found, text
    first, last = int(found[1]), int(found[2])
    assert (first, last) == (int(found[3]), int(found[4]))
    assert first >= 100000
    assert last - first + 1 == 65536


def test_a_root_that_cannot_be_made_shows_why_and_nothing_of_tar(machine):
    machine.has("id", "echo 0")
    machine.has("mmdebstrap", "echo no such mirror >&2; exit 1")
    ended = machine.dev("shell", "true")
    assert ended.returncode == 1
    assert "no such mirror" in ended.stderr
    assert "the root could not be made; the log above is" in ended.stderr.splitlines()[-1]


def test_the_demo_asks_for_what_the_programs_need_and_tests_for_the_rest(machine):
    entered = [machine.entered(command)[1] for command in ("demo", "serve", "test", "docs", "demo")]
    programs, everything = machine.roots()
    assert {"g++", "libmfem-dev", "python3-matplotlib"} <= programs < everything
    assert everything - programs >= {"catch2", "furo", "lintian"}
    assert entered[0] == entered[1] != entered[2] == entered[3] == entered[4], "the root with everything serves all"


def test_a_system_is_asked_for_what_the_command_needs(machine):
    machine.environment["CONTACTD_DEV"] = "system"
    asked = [set(machine.dev(command).stderr.split("--no-install-recommends ")[1].split()) for command in ("demo", "test")]
    assert asked[0] < asked[1]
    assert "catch2" in asked[1] - asked[0]


def test_the_demo_builds_daemon_and_builder_in_the_folder_of_production(machine):
    assert machine.built("demo") == ["--preset programs", "--build --preset programs"]
    presets = json.loads((ROOT / "CMakePresets.json").read_text())
    (built,) = [preset for preset in presets["buildPresets"] if preset["name"] == "programs"]
    (configured,) = [preset for preset in presets["configurePresets"] if preset["name"] == "programs"]
    assert built["targets"] == ["contactd", "contactd-ic"]
    assert (configured["inherits"], configured["binaryDir"]) == ("production", "${sourceDir}/build/production")


def test_a_command_builds_what_it_runs(machine):
    assert machine.built("docs")[-1] == "--build --preset development --target site-programs"
    assert machine.built("faults")[-1] == "--build --preset development --target contactd contactd-ic"
    assert machine.built("paper", "fem")[-1] == "--build --preset production --target contactd contactd-ic block_system"
    assert machine.built("validate")[-1] == "--build --preset production --target contactd_local"
    assert machine.built("build", "production", "contactd")[-1] == "--build --preset production --target contactd"
    assert machine.built("fuzz", "10", "request")[-1] == "--build --preset fuzz --target fuzz_request"
    assert machine.built("fuzz")[-1] == "--build --preset fuzz"
    assert machine.built("build")[-1] == "--build --preset development"


def test_a_root_whose_making_was_cut_short_is_made_again(machine):
    root = Path(machine.entered("demo")[1])
    (root / ".complete").unlink()
    (half := Path(f"{root}.a1B2c3")).mkdir()
    assert machine.entered("demo")[1] == str(root)
    assert len(machine.roots()) == 2
    assert (root / ".complete").exists()
    assert not half.exists()


def test_of_several_who_want_a_root_at_once_one_makes_it(machine):
    machine.has("id", "echo 0")
    machine.has("mmdebstrap", STANDINS["mmdebstrap"] + "; /bin/sleep 1")
    with ThreadPoolExecutor() as pool:
        ended = list(pool.map(lambda _: machine.dev("demo"), range(3)))
    assert [one.returncode for one in ended] == [0, 0, 0]
    assert len(machine.roots()) == 1


def test_without_a_network_a_root_that_is_there_serves_the_demo_and_a_new_one_says_what_fails(machine):
    machine.entered("demo")
    machine.has("mmdebstrap", "echo no network >&2; exit 1")
    machine.entered("demo")
    ended = machine.dev("test")
    assert ended.returncode == 1
    assert "no network" in ended.stderr
    assert len(list((machine.home / ".cache" / "contactd").glob("root-*/.complete"))) == 1


def test_the_root_sees_home_and_the_folder_that_dev_was_called_from(machine):
    words = machine.entered("shell", "cat", "notes.txt")
    assert {str(machine.home), str(machine.work), str(ROOT), str(machine.home / ".cache" / "contactd")} <= set(bound(words))
    assert setting(words, "CONTACTD_CALLED_FROM") == str(machine.work)
    assert words[-3:] == ["shell", "cat", "notes.txt"]


@pytest.mark.parametrize("folder", ["/", "/usr", "/usr/share", "/etc", "/var"])
def test_the_roots_own_system_is_not_hidden_by_the_machines(machine, folder):
    assert folder not in bound(machine.entered("shell", "true", folder=Path(folder)))


def test_the_daemons_default_store_lies_where_it_is_documented(machine):
    words = machine.entered("serve")
    assert setting(words, "XDG_CACHE_HOME") == str(machine.home / ".cache")
    assert setting(words, "HOME") == str(machine.home / ".cache" / "contactd" / "home")
    machine.environment["XDG_CACHE_HOME"] = str(machine.work / "cache")
    assert setting(machine.entered("serve"), "XDG_CACHE_HOME") == str(machine.work / "cache")


def test_a_command_runs_in_the_folder_that_dev_was_called_from(machine):
    """Acts as in the root, where this script is called again."""
    (machine.work / "notes.txt").write_text("mine\n")
    machine.environment |= {"CONTACTD_INSIDE": "1", "CONTACTD_CALLED_FROM": str(machine.work)}
    assert machine.dev("shell", "cat", "notes.txt", folder=ROOT).stdout == "mine\n"


def test_dev_called_again_by_a_command_starts_from_where_that_is(machine):
    machine.environment |= {"CONTACTD_INSIDE": "1", "CONTACTD_CALLED_FROM": "/"}
    command = f"cd {machine.work} && {ROOT}/dev shell pwd"
    machine.programs.joinpath("pwd").symlink_to("/usr/bin/pwd")
    assert machine.dev("shell", "bash", "-c", command).stdout == f"{machine.work}\n"


def test_help_says_what_the_root_sees(machine):
    text = re.sub(r"\s+", " ", machine.dev("help").stdout)
    assert (
        "Programs in that root can access the repository, your home folder, the folder ./dev was called from, /tmp, and the cache folder"
        in text
    )
    assert "default store is store/ in it" in text


def test_the_readme_names_the_clients_that_there_are():
    (clients,) = re.findall(r"call it from (.*?)\s+terminal:", (ROOT / "README.md").read_text(), re.DOTALL)
    names = {"c": "C, Fortran or MATLAB", "cpp": "C++", "fmu": "FMUs", "python": "Python"}
    another_program = {"cntc"}  # whose calls it has
    folders = {path.name for path in (ROOT / "client").iterdir() if path.is_dir()} - another_program
    assert folders == set(names)
    assert [folder for folder in folders if names[folder] not in clients] == []
    assert not re.search(r"client \(.*shell\)", (ROOT / "docs" / "architecture.md").read_text())


#: After these commands, a word names a part with a separate line; after others an option does.
OF_PARTS = {"demo", "load", "paper", "sanitize"}
#: Options that select less, or print more, of the same command.
OF_DETAIL = {"--all", "--bin", "--cases", "--fresh", "--help", "--key", "--last", "--long", "--only", "--preset"}


def named_commands(text: str) -> set[tuple[str, ...]]:
    """Returns each command of ./dev in the text, with its part or the option that makes it a different one."""
    found = set()
    for line in re.findall(r"(?m)(?:^ +|`|& )\./dev ((?:[a-z0-9]+)(?: (?:--)?[a-z]+)*)", text):
        first, *rest = line.split()
        own = [word for word in rest[:1] if first in OF_PARTS or word.startswith("--")]
        found.add((first, *(word for word in own if word not in OF_DETAIL)))
    return found


@pytest.fixture
def release(machine):
    """Provides a checkout with commands to run before a release, whose root records each requested command."""
    checkout, log = machine.work / "checkout", machine.work / "commands.log"
    (checkout / "tests").mkdir(parents=True)
    (checkout / "configs").mkdir()
    shutil.copytree(ROOT / "packaging", checkout / "packaging")
    shutil.copy(ROOT / "dev", checkout)
    shutil.copy(ROOT / "configs" / "contactd.json", checkout / "configs")
    (checkout / "tests" / "documented_commands.txt").write_text("# Of ./dev.\n\ndemo\nserve\npaper fem\n- bench: slow\ndocs\n")
    machine.has("id", "echo 0")
    for name in ("seq", "sleep"):
        (machine.programs / name).symlink_to(shutil.which(name))

    def run(**ends: str) -> tuple[int, str, list[str]]:
        """Returns its exit status, its last line and the commands that ran; `ends` maps first words of commands to
        scripts."""
        cases = "".join(f"{word}) {script} ;;\n" for word, script in ends.items())
        machine.has("bwrap", f"""while [ "$1" != -- ]; do shift; done; shift 2\necho "$@" >>{log}\ncase $1 in {cases}esac""")
        ended = subprocess.run(
            [checkout / "dev", "test", "--long"], env=machine.environment, capture_output=True, text=True, timeout=50,
            start_new_session=True,
        )  # fmt: skip
        return ended.returncode, ended.stderr.splitlines()[-1], log.read_text().splitlines()

    return run


SERVES = "echo ready >served; exec sleep 30"
ASKED = "[ -e served ]"  # the daemon answers once it listens


def test_what_comes_before_a_release_runs_each_listed_command_once(release):
    status, _, ran = release(serve=SERVES, shell=ASKED)
    assert status == 0
    pings = [line for line in ran if line.startswith("shell")]
    assert len(pings) >= 2, "none may answer before ./dev serve"
    assert [line for line in ran if line not in pings] == ["test --long", "demo", "build programs", "serve", "paper fem", "docs"]


def test_commands_that_fail_before_a_release_are_named_and_the_others_run(release):
    status, last, ran = release(test="exit 1", serve=SERVES, shell=ASKED, paper="exit 3")
    assert (status, last) == (1, "dev: failed: ./dev test --long, ./dev paper fem")
    assert ran[-1] == "docs"


def test_another_daemon_does_not_answer_for_the_one_that_is_tried(release):
    status, last, _ = release(serve="exec sleep 30", shell="exit 0")
    assert (status, last) == (1, "dev: failed: ./dev serve")


def test_a_server_that_ends_at_once_fails(release):
    status, last, _ = release(serve="exit 1", shell="exit 1")
    assert (status, last) == (1, "dev: failed: ./dev serve")


def test_an_interrupt_ends_what_comes_before_a_release_though_its_command_ends_in_order(release):
    status, last, ran = release(demo="trap 'exit 130' INT; kill -INT 0")
    assert (status, last) == (1, "dev: interrupted")
    assert ran == ["test --long", "demo"]


def test_each_command_that_a_page_or_the_help_names_is_run_before_a_release(machine):
    lines = (ROOT / "tests" / "documented_commands.txt").read_text().splitlines()
    listed = [line.removeprefix("- ").partition(":")[0].split() for line in lines if line and not line.startswith("#")]
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "tests" / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "developing").glob("*.md")]
    code = [re.findall(r"`\./dev [^`]*`|^ {4}.*$", page.read_text(), re.MULTILINE) for page in pages]
    text = machine.dev("help").stdout + "\n".join("\n".join(parts) for parts in code)
    commands = named_commands(text)
    assert len(commands) > 25
    missing = [words for words in commands if not any(words[0] == line[0] and set(words) <= set(line) for line in listed)]
    assert missing == []

"""Tests the assembly of the binary wheels; `./dev wheel --test` installs and uses them."""

from __future__ import annotations

import platform
import re
import subprocess
import sys
import zipfile
from email import message_from_bytes
from pathlib import Path

import pytest
import tomllib

import contactd
from contactd.transport.programs import program_of
from support.daemons import BIN

ROOT = Path(__file__).parents[2]
WHEELS = ROOT / "packaging" / "wheels"
sys.path.insert(0, str(WHEELS))

from elf import is_elf, links, machine_of, own_folders  # noqa: E402
from licenses import Origins  # noqa: E402
from local_wheel import local_wheel  # noqa: E402
from project import copied, say, wheel  # noqa: E402

MODULE = next((BIN.parent / "lib" / "python").glob("contactd_local*.so"))


def opened(wheel):
    """Returns its contents, without the name of the metadata folder, and the modes of the files."""
    with zipfile.ZipFile(wheel) as archive:
        content = {re.sub(r"^[^/]*\.dist-info/", "", name): archive.read(name) for name in archive.namelist()}
        modes = {entry.filename: entry.external_attr >> 16 & 0o777 for entry in archive.infolist()}
    return content, modes


@pytest.fixture
def programs(tmp_path):
    """Creates a wheel of fake programs, in a folder."""
    with copied(WHEELS / "daemon") as project:
        say(project, "1.2", ["hdf5 1.14"], {"libstdc++6.txt": "as you like\n"})
        for place, mode in (("__init__.py", 0o644), ("bin/contactd", 0o755), ("lib/libc.so.6", 0o644), ("programs/contactd", 0o755)):
            file = project / "contactd_daemon" / place
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(f"{place}\n")
            file.chmod(mode)
        return wheel(project, tmp_path)


def test_the_wheel_of_the_programs_runs_on_any_linux_and_python(programs):
    content, modes = opened(programs)
    assert programs.name == "contactd_daemon-1.2-py3-none-manylinux_2_17_x86_64.whl"
    assert modes["contactd_daemon/bin/contactd"] == modes["contactd_daemon/programs/contactd"] == 0o755
    assert modes["contactd_daemon/lib/libc.so.6"] == 0o644
    points = content["entry_points.txt"].decode()
    assert "contactd = contactd_daemon:_contactd\n" in points
    assert "contactd-ic = contactd_daemon:_contactd_ic\n" in points


def test_a_wheel_tells_its_licences_and_sources(programs):
    content, _ = opened(programs)
    metadata = message_from_bytes(content["METADATA"])
    assert (metadata["Name"], metadata["License-Expression"]) == ("contactd-daemon", "GPL-3.0-or-later")
    assert metadata["Requires-Python"] == ">=3.10"
    assert metadata.get_payload().endswith("Debian's source packages:\n\n- hdf5 1.14\n")
    texts = {Path(name).name: text for name, text in content.items() if name.startswith("licenses/")}
    assert texts.pop("contactd.txt") == (ROOT / "LICENSE").read_bytes()
    assert texts == {"libstdcxx6.txt": b"as you like\n"}
    assert not [name for name in content if name.startswith("licenses.")]


def test_no_time_of_the_making_is_in_a_wheel(programs):
    with zipfile.ZipFile(programs) as archive:
        assert {entry.date_time[0] for entry in archive.infolist()} == {1980}


def test_the_module_is_the_only_thing_that_its_wheel_puts_beside_others(tmp_path):
    (tmp_path / "licenses").mkdir()
    (tmp_path / "licenses" / "hdf5").write_text("as HDF5 likes\n")
    (tmp_path / "sources.txt").write_text("hdf5_1.14.tar.gz\n")
    made = local_wheel(MODULE, [tmp_path], "1.2", tmp_path)
    content, _ = opened(made)
    assert made.name == "contactd_local-1.2-cp310-abi3-linux_x86_64.whl"
    assert content["contactd_local.abi3.so"] == MODULE.read_bytes()
    about = {name for name in content if name.startswith("licenses/")}
    assert content.keys() - about == {"contactd_local.abi3.so", "METADATA", "WHEEL", "RECORD", "top_level.txt"}
    assert "hdf5.txt" in {Path(name).name for name in about}
    assert b"- hdf5_1.14.tar.gz\n" in content["METADATA"]


def test_the_wheel_of_the_client_has_its_packages_and_nothing_of_other_wheels(tmp_path):
    with copied(ROOT / "client" / "python") as project:
        made = wheel(project, tmp_path)
    content, _ = opened(made)
    assert made.name == f"contactd-{contactd.__version__}-py3-none-any.whl"
    assert {name.split("/")[0] for name in content if name.endswith(".py")} == {"contactd", "contactctl"}
    ours = {path.relative_to(ROOT / "client/python") for package in ("contactd", "contactctl") for path in (ROOT / "client/python" / package).rglob("*.py")}
    examples = {"contactd" / path.relative_to(ROOT / "client/python") for path in (ROOT / "client/python/examples").rglob("*.py")}
    assert {Path(name) for name in content if name.endswith(".py")} == ours | examples
    assert "contactd/examples/creep_tables/study.yaml" in content
    assert {"contactd/py.typed", "licenses/LICENSE"} <= content.keys()


@pytest.mark.parametrize("program", [BIN / "contactd", BIN / "contactd-ic", MODULE], ids=lambda path: path.name)
def test_what_is_packed_looks_for_libraries_in_no_folder_of_this_machine(program):
    assert is_elf(program)
    assert own_folders(program) == []


def test_all_that_a_program_needs_is_found_with_the_loader():
    found = links(BIN / "contactd")
    assert {"libc.so.6", "ld-linux-x86-64.so.2", "libzmq.so.5"} <= found.keys()
    assert all(path.is_file() and is_elf(path) for path in found.values())
    assert "libc6" in Origins([found["libc.so.6"]]).packages


def test_a_wheel_says_for_which_processor_its_module_is(tmp_path):
    assert machine_of(MODULE) == platform.machine()
    of_arm64 = tmp_path / "contactd_local.abi3.so"
    of_arm64.write_bytes(b"\x7fELF" + bytes(14) + (183).to_bytes(2, "little"))
    assert machine_of(of_arm64) == "aarch64"
    with copied(WHEELS / "local") as project:
        say(project, "1.2", [], {})
        (project / of_arm64.name).write_bytes(of_arm64.read_bytes())
        assert wheel(project, tmp_path, "linux-aarch64").name == "contactd_local-1.2-cp310-abi3-linux_aarch64.whl"


def test_the_wheel_of_a_module_for_windows_has_it_under_the_name_that_python_looks_for_there(tmp_path):
    with copied(WHEELS / "local") as project:
        say(project, "1.2", [], {})
        (project / "contactd_local.pyd").write_bytes(b"MZ")
        made = wheel(project, tmp_path, "win-amd64")
    assert made.name == "contactd_local-1.2-cp310-abi3-win_amd64.whl"
    assert opened(made)[0]["contactd_local.pyd"] == b"MZ"


def test_licences_come_with_the_texts_that_they_name():
    origins = Origins(links(BIN / "contactd-ic").values())
    texts = origins.texts()
    assert "GPL-2" in texts["libcholmod5.txt"]
    assert "GNU GENERAL PUBLIC LICENSE" in texts["common-GPL-2.txt"]
    assert any(re.fullmatch(r"suitesparse .*", source) for source in origins.sources())


def test_the_module_serves_all_later_versions_of_python():
    assert MODULE.name == "contactd_local.abi3.so"
    asked = subprocess.run(["readelf", "--dyn-syms", "-W", MODULE], capture_output=True, text=True, check=True).stdout
    functions = set(re.findall(r"UND (Py\w+|_Py\w+)", asked))
    assert functions
    assert not {name for name in functions if name.startswith("_Py")} - {"_Py_NoneStruct", "_Py_Dealloc"}


def test_the_extras_ask_for_wheels_of_the_same_version():
    project = tomllib.loads((ROOT / "client" / "python" / "pyproject.toml").read_text())["project"]
    assert project["version"] == contactd.__version__
    extras = project["optional-dependencies"]
    assert extras["local"] == [f"contactd-local=={contactd.__version__}"]
    assert extras["daemon"] == [f"contactd-daemon=={contactd.__version__}"]


def test_a_program_is_started_by_the_loader_that_lies_beside_it(tmp_path):
    places = tmp_path / "at home"
    (places / "bin").mkdir(parents=True)
    start = (WHEELS / "start.sh").read_text().replace("LOADER", "loader").replace("NAME", "contactd")
    for name, text in (("contactd", start), ("loader", '#!/bin/sh\nprintf "%s\\n" "$@"\n')):
        (places / "bin" / name).write_text(text)
        (places / "bin" / name).chmod(0o755)
    (tmp_path / "elsewhere").symlink_to(places / "bin" / "contactd")
    output = subprocess.run([tmp_path / "elsewhere", "--x", "a b"], capture_output=True, text=True, check=True).stdout
    assert output.splitlines() == [
        "--inhibit-cache", "--library-path", f"{places}/bin/../lib", "--argv0", f"{tmp_path}/elsewhere",
        f"{places}/bin/../programs/contactd", "--x", "a b",
    ]  # fmt: skip


def test_the_package_with_the_programs_comes_before_the_path(tmp_path, monkeypatch):
    assert program_of("contactd") == "contactd"
    package = tmp_path / "contactd_daemon"
    (package / "bin").mkdir(parents=True)
    (package / "__init__.py").write_text((ROOT / "client/python/daemon/contactd_daemon/__init__.py").read_text())
    (package / "bin" / "contactd").touch()
    monkeypatch.syspath_prepend(tmp_path)
    assert program_of("contactd") == str(package / "bin" / "contactd")
    assert program_of("contactd-ic") == "contactd-ic", "which is not there"

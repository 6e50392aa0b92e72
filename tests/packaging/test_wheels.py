"""How the binary wheels are put together; `./dev wheel --test` installs and uses them."""

from __future__ import annotations

import base64
import hashlib
import re
import subprocess
import sys
import zipfile
from email import message_from_bytes
from pathlib import Path

import pytest
import tomllib

import contactd
from contactd.programs import program_of
from support.daemons import BIN

ROOT = Path(__file__).parents[2]
WHEELS = ROOT / "packaging" / "wheels"
sys.path.insert(0, str(WHEELS))

from elf import is_elf, links, newest_glibc, own_folders  # noqa: E402
from licenses import Origins  # noqa: E402
from local_wheel import local_wheel  # noqa: E402
from wheel_file import Wheel  # noqa: E402

MODULE = next((BIN.parent / "lib" / "python").glob("contactd_local*.so"))


@pytest.fixture
def wheel(tmp_path):
    made = Wheel("contactd-thing", "1.2", "A thing", "BSD-3-Clause", "cp310-abi3-manylinux_2_34_x86_64", "# Thing\n")
    made.files = {"thing/__init__.py": b"answer = 42\n", "thing/bin/go": b"#!/bin/sh\n"}
    made.programs = {"thing/bin/go"}
    made.scripts = {"go": "thing:go"}
    made.licenses = {"thing.txt": "as you like\n"}
    (tmp_path / "contactd_thing-1.1-py3-none-any.whl").touch()
    return made.write(tmp_path)


def test_a_wheel_takes_the_place_of_an_earlier_one(wheel):
    assert wheel.name == "contactd_thing-1.2-cp310-abi3-manylinux_2_34_x86_64.whl"
    assert list(wheel.parent.glob("*.whl")) == [wheel]


def test_a_wheel_says_what_is_in_it(wheel):
    with zipfile.ZipFile(wheel) as archive:
        info = "contactd_thing-1.2.dist-info"
        content = {name: archive.read(name) for name in archive.namelist()}
        modes = {entry.filename: entry.external_attr >> 16 for entry in archive.infolist()}
    metadata = message_from_bytes(content[f"{info}/METADATA"])
    assert (metadata["Name"], metadata["Version"], metadata["License"]) == ("contactd-thing", "1.2", "BSD-3-Clause")
    assert metadata["License-File"] == "thing.txt"
    assert content[f"{info}/licenses/thing.txt"] == b"as you like\n"
    assert b"Tag: cp310-abi3-manylinux_2_34_x86_64\n" in content[f"{info}/WHEEL"]
    assert content[f"{info}/entry_points.txt"] == b"[console_scripts]\ngo = thing:go\n"
    assert (modes["thing/bin/go"], modes["thing/__init__.py"]) == (0o100755, 0o100644)
    record = dict(line.split(",", 1) for line in content[f"{info}/RECORD"].decode().splitlines())
    assert record.keys() == content.keys()
    for name, data in content.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
        assert record[name] == ("," if name.endswith("/RECORD") else f"sha256={digest},{len(data)}")


@pytest.mark.parametrize("program", [BIN / "contactd", BIN / "contactd-ic", MODULE], ids=lambda path: path.name)
def test_what_is_packed_looks_for_libraries_in_no_folder_of_this_machine(program):
    assert is_elf(program)
    assert own_folders(program) == []
    assert newest_glibc(program) >= (2, 17)


def test_all_that_a_program_needs_is_found_with_the_loader():
    found = links(BIN / "contactd")
    assert {"libc.so.6", "ld-linux-x86-64.so.2", "libzmq.so.5"} <= found.keys()
    assert all(path.is_file() and is_elf(path) for path in found.values())
    assert "libc6" in Origins([found["libc.so.6"]]).packages


def test_licences_come_with_the_texts_that_they_name():
    origins = Origins(links(BIN / "contactd").values())
    texts = origins.texts()
    assert "GPL-2" in texts["libfftw3-double3.txt"]
    assert "GNU GENERAL PUBLIC LICENSE" in texts["common-GPL-2.txt"]
    assert any(re.fullmatch(r"fftw3 3\..*", source) for source in origins.sources())


def test_what_needs_libraries_of_this_machine_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r"needs \[.*libfftw3\.so\.3.*its libraries must be inside"):
        local_wheel(BIN / "contactd", tmp_path, "1.0", "")


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
    said = subprocess.run([tmp_path / "elsewhere", "--x", "a b"], capture_output=True, text=True, check=True).stdout
    assert said.splitlines() == [
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

"""Tests parts of a build that CMake's options exclude: the rest configures, builds, and is installed."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from support.daemons import BIN

ROOT = Path(__file__).parents[2]
WITHOUT = ("-DCONTACTD_SERVER=OFF", "-DCONTACTD_FEM=OFF", "-DCONTACTD_TESTS=OFF")
CONSUMER = """cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES C)
find_package(contactd 0.1 REQUIRED COMPONENTS c_local)
add_executable(consumer main.c)
target_link_libraries(consumer PRIVATE contactd::c_local)
"""
PROGRAM = """#include <contactd.h>

int main(void) {
    contactd_connection* connection;
    if (contactd_open("tcp://127.0.0.1:1", &connection) != CONTACTD_UNIMPLEMENTED) return 1;
    return contactd_open("local", &connection) == CONTACTD_OK && contactd_close(connection) == CONTACTD_OK ? 0 : 2;
}
"""


def run(*command: str | Path) -> str:
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, f"{command}:\n{ended.stdout[-3000:]}{ended.stderr[-3000:]}"
    return ended.stdout


def of_the_build(name: str) -> list[str]:
    """Returns an entry of the cache of the programs under test, as an option."""
    cache = BIN.parent / "CMakeCache.txt"
    found = re.search(rf"^{name}:\w+=(.+)$", cache.read_text(), re.MULTILINE) if cache.exists() else None
    return [f"-D{name}={found[1]}"] if found else []


def configured(build: Path, options: Sequence[str]) -> set[str]:
    """Returns the existing targets."""
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCONTACTD_UNITY=ON", *of_the_build("CONTACTD_DUCC0"), *options)
    return set(re.findall(r"^(\S+): ", run("ninja", "-C", build, "-t", "targets", "all"), re.MULTILINE))


@pytest.mark.parametrize(
    ("left_out", "there", "gone"),
    [
        (["REMOTE"], {"libcontactd-local.so", "contactd", "congruence-c-local"}, {"libcontactd.so", "libcontactd_client.a"}),
        (["REMOTE", "SERVER", "FEM"], {"libcontactd-local.so", "test_client_c"}, {"libcontactd.so", "contactd", "test_client_cpp"}),
        (["SERVER"], {"libcontactd.so", "platform-cases", "congruence-c-local"}, {"contactd"}),
        (["CORE", "SERVER", "FEM"], {"libcontactd.so", "libcontactd_client.a"}, {"libcontactd-local.so"}),
        (["CORE", "REMOTE", "SERVER", "FEM"], {"libcontactd_proto.a"}, {"libcontactd.so", "libcontactd-local.so"}),
    ],
    ids=lambda names: "-".join(sorted(names)),
)
@pytest.mark.timeout(300)
def test_what_is_left_out_is_gone_and_the_rest_configures(tmp_path, left_out, there, gone):
    targets = {Path(target).name for target in configured(tmp_path / "build", [f"-DCONTACTD_{name}=OFF" for name in left_out])}
    assert there <= targets
    assert not gone & targets


@pytest.mark.long  # compiles core again; ./dev package --test runs it, too
@pytest.mark.timeout(1800)
def test_the_library_in_process_is_built_and_used_without_zeromq(tmp_path):
    build = BIN.parents[1] / "without-remote"  # beside the others, where the cache of ./dev contains its sources
    launcher = []
    if shutil.which("ccache"):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
        os.environ.setdefault("CCACHE_BASEDIR", str(ROOT))
        os.environ.setdefault("CCACHE_NOHASHDIR", "1")
    targets = configured(build, ["-DCONTACTD_REMOTE=OFF", *WITHOUT, *launcher])
    assert not [target for target in targets if "zmq" in target]
    run("cmake", "--build", build, "--target", "contactd_local_c", "contactd_cntc", "contactd-c-examples")
    assert "zmq" not in run("ldd", build / "lib" / "libcontactd-local.so")
    for component in ("c_local_library", "c_development", "cntc", "cntc_development"):
        run("cmake", "--install", build, "--prefix", tmp_path / "installed", "--component", component)
    (tmp_path / "CMakeLists.txt").write_text(CONSUMER)
    (tmp_path / "main.c").write_text(PROGRAM)
    run("cmake", "-S", tmp_path, "-B", tmp_path / "consumer", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={tmp_path / 'installed'}")
    run("cmake", "--build", tmp_path / "consumer")
    run(tmp_path / "consumer" / "consumer")

"""Tests that the files of packaging/ name existing things and agree with each other; `./dev package --test` installs
them."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGING = ROOT / "packaging"
BIN = Path(os.environ.get("CONTACTD_BIN", ROOT / "build" / "development" / "bin"))
SCRIPTS = sorted([*PACKAGING.glob("*.sh"), *PACKAGING.glob("debian/*inst"), *PACKAGING.glob("debian/*rm")])


def instructions() -> list[tuple[str, str]]:
    """Returns instructions and arguments of the Dockerfile, with continued lines joined."""
    text = re.sub(r"\\\n\s*", " ", (PACKAGING / "Dockerfile").read_text())
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    return [(line.split(" ", 1)[0], line.split(" ", 1)[1]) for line in lines]


def helped(program: str) -> set[str]:
    """Returns the long options that --help shows."""
    shown = subprocess.run([BIN / program, "--help"], capture_output=True, text=True, timeout=30, check=True).stdout
    return set(re.findall(r"--[a-z][a-z-]+", shown))


def test_what_the_image_copies_exists() -> None:
    copied = [arguments.split() for word, arguments in instructions() if word == "COPY"]
    for sources in (arguments[:-1] for arguments in copied if not arguments[0].startswith("--from")):
        assert all((ROOT / source).exists() for source in sources), sources


def test_the_image_takes_the_package_from_where_it_is_made() -> None:
    (source,) = [a.split()[1] for word, a in instructions() if word == "COPY" and a.startswith("--from=build")]
    assert source == "/src/build/package/packages/contactd_*_amd64.deb"
    assert "cpack --config CPackConfig.cmake -B packages" in (ROOT / "dev").read_text()
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    assert any(preset["name"] == "package" for preset in presets)


def test_the_image_does_not_run_as_root_and_asks_for_its_health() -> None:
    last = [word for word, _ in instructions()].index("FROM", 1)
    words = dict(instructions()[last:])
    assert words["USER"] == "contactd"
    assert f"adduser --quiet --system --group --no-create-home --home {words['WORKDIR']}" in (
        PACKAGING / "debian" / "postinst"
    ).read_text()
    health = json.loads(words["HEALTHCHECK"].split("CMD", 1)[1])
    assert health[0] == "contactd"
    assert health[1] in helped("contactd")
    port = json.loads((ROOT / "configs" / "container.json").read_text())["endpoint"].rsplit(":", 1)[1]
    assert health[2].endswith(f":{port}")
    assert words["EXPOSE"] == port


@pytest.mark.parametrize("config", ["packaging/contactd.json", "configs/container.json"])
def test_the_configurations_of_package_and_image_are_taken(config: str) -> None:
    ended = subprocess.run(
        [BIN / "contactd", "--config", ROOT / config, "--print-config"], capture_output=True, text=True, timeout=30
    )
    assert ended.returncode == 0, ended.stderr
    assert json.loads(ended.stdout)["store"]["folder"] == "/var/lib/contactd/store"


def test_the_unit_starts_what_the_package_installs() -> None:
    unit = (PACKAGING / "contactd.service").read_text()
    rules = (ROOT / "cmake" / "contactd_package.cmake").read_text()
    assert "ExecStart=/usr/bin/contactd --config /etc/contactd/contactd.json\n" in unit
    assert "contactd.json DESTINATION /etc/contactd " in rules
    assert '"/etc/contactd/contactd.json\\n"' in rules, "the configuration is no conffile"
    drain = json.loads((ROOT / "configs" / "schema.json").read_text())["properties"]["shutdown"]
    limit = re.search(r"TimeoutStopSec=(\d+)", unit)
    assert limit is not None
    assert int(limit.group(1)) > drain["properties"]["drain_seconds"]["default"] + 7, "the drain would be cut short"


@pytest.mark.parametrize(("program", "page"), [("contactd", "contactd.8"), ("contactd-ic", "contactd-ic.1")])
def test_the_manual_page_has_every_option(program: str, page: str) -> None:
    text = (PACKAGING / "man" / page).read_text().replace("\\-", "-")
    assert set(re.findall(r"--[a-z][a-z-]+", text)) == helped(program)


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda p: p.name)
def test_scripts_can_be_read_by_their_shell(script: Path) -> None:
    shell = "bash" if "bash" in script.read_text().splitlines()[0] else "sh"
    subprocess.run([shell, "-n", script], check=True, timeout=30)

"""Tests that recipes for conda-forge and Spack name existing options, targets, components, versions and packages.
Neither program is available here: conda's recipe is read as text, and Spack's class is run with replacements."""

from __future__ import annotations

import re
import subprocess
import sys
import types
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).parents[2]
CONDA = ROOT / "packaging" / "conda"
PROJECT = (ROOT / "client" / "python" / "pyproject.toml").read_text()
LISTS = "\n".join(path.read_text() for path in [*ROOT.rglob("client/**/CMakeLists.txt"), *(ROOT / "cmake").glob("*.cmake"), ROOT / "CMakeLists.txt"])


@pytest.fixture(scope="module")
def recipe() -> dict[str, Any]:
    found: dict[str, Any] = yaml.safe_load((CONDA / "recipe.yaml").read_text())
    return found


def options_of(arguments: list[str]) -> dict[str, str]:
    return dict(re.findall(r"-D(CONTACTD_\w+)(?::\w+)?=(\S+)", " ".join(arguments)))


def check_options(options: dict[str, str]) -> None:
    known = set(re.findall(r"(?:option|set)\((CONTACTD_\w+)", LISTS))
    assert set(options) <= known
    assert options["CONTACTD_SERVER"] in ("OFF", "False")


def test_the_version_is_that_of_the_project(recipe):
    version = re.search(r"project\(contactd VERSION (\S+) ", (ROOT / "CMakeLists.txt").read_text())
    assert version
    assert recipe["context"]["version"] == version[1]
    assert f'version("{version[1]}")' in (ROOT / "packaging" / "spack" / "package.py").read_text()


def test_the_client_of_conda_needs_what_the_project_needs(recipe):
    (client,) = (output for output in recipe["outputs"] if output["package"]["name"] == "contactd")
    needed = re.findall(r'"([\w-]+)(>=[\d.]+)"', re.findall(r"^dependencies = \[(.*)\]", PROJECT, re.MULTILINE)[0])
    python = re.findall(r'^requires-python = "(.+)"', PROJECT, re.MULTILINE)
    assert client["requirements"]["run"] == [f"python {python[0]}", *(f"{name} {bound}" for name, bound in needed)]
    command = re.findall(r'^scripts = \{contactctl = "(.+)"\}', PROJECT, re.MULTILINE)
    assert client["build"]["python"]["entry_points"] == [f"contactctl = {command[0]}"]


def test_the_script_of_conda_builds_and_installs_what_there_is(recipe):
    script = (CONDA / "build.sh").read_text()
    subprocess.run(["bash", "-n", CONDA / "build.sh"], check=True)
    check_options(options_of(script.split()))
    (targets,) = re.findall(r"--target (.*?) --parallel", script)
    assert all(target in LISTS for target in targets.split())
    (components,) = re.findall(r"for component in (.*?); do", script)
    assert all(re.search(rf"COMPONENT {component}\b|\b{component}\)", LISTS) for component in components.split())
    library = recipe["outputs"][0]
    assert library["build"]["script"]["file"] == "build.sh"
    assert set(library["tests"][0]["package_contents"]["include"]) == {"contactd.h", "contactd_cntc.h"}


class Spec:
    """Replaces the parts of Spack that the recipe uses."""

    def __init__(self, *variants: str) -> None:
        self.variants = variants

    def satisfies(self, what: str) -> bool:
        return what in self.variants


def spack() -> tuple[type, list[tuple[str, tuple[Any, ...], dict[str, Any]]]]:
    """Returns the class of the recipe, and the directives that it calls."""
    called: list[tuple[str, tuple[Any, ...], dict[str, Any]]] = []
    module = types.ModuleType("spack.package")
    for name in ("license", "version", "variant", "depends_on", "extends", "generator"):
        setattr(module, name, lambda *given, _name=name, **named: called.append((_name, given, named)))
    module.CMakePackage = type("CMakePackage", (), {"define": staticmethod(lambda name, value: f"-D{name}={value}")})  # type: ignore[attr-defined]
    module.run_after = lambda _phase: lambda function: function  # type: ignore[attr-defined]
    path = ROOT / "packaging" / "spack" / "package.py"
    sys.modules.update({"spack": types.ModuleType("spack"), "spack.package": module})
    names: dict[str, Any] = {}
    try:
        exec(compile(path.read_text(), str(path), "exec"), names)
    finally:
        del sys.modules["spack"], sys.modules["spack.package"]
    return names["Contactd"], called


@pytest.mark.parametrize("variants", [(), ("+fftw",)], ids=["ducc0", "fftw"])
def test_the_recipe_of_spack_configures_with_options_that_there_are(variants):
    recipe, _ = spack()
    package = recipe()
    package.spec = Spec(*variants)
    options = options_of(package.cmake_args())
    check_options(options)
    assert options["CONTACTD_FFT"] == (variants[0].strip("+") if variants else "ducc0")
    assert all(target in LISTS for target in recipe.build_targets)


def test_what_the_recipe_of_spack_depends_on_when_is_one_of_its_variants():
    _, called = spack()
    variants = {given[0] for name, given, _ in called if name == "variant"}
    conditions = {named["when"] for _, _, named in called if "when" in named}
    assert conditions == {f"+{variant}" for variant in variants}
    assert ("license", ("BSD-3-Clause",)) in [(name, given) for name, given, _ in called]


def test_both_recipes_bring_what_cmake_looks_for(recipe):
    looked_for = {"eigen": "Eigen3", "hdf5": "HDF5", "libsodium": "libsodium", "cppzmq": "cppzmq", "reproc": "reproc++", "json": "nlohmann_json"}
    texts = "\n".join((ROOT / folder / "CMakeLists.txt").read_text() for folder in ("core", "proto", "engine", "client/cpp"))
    _, called = spack()
    of_spack = " ".join(given[0] for name, given, _ in called if name == "depends_on")
    of_conda = " ".join(map(str, recipe["outputs"][0]["requirements"]["host"]))
    for part, package in looked_for.items():
        assert package in texts
        assert part in of_spack
        assert part in of_conda

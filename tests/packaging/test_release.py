"""Tests that releases are complete, signed and reproducible."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "packaging" / "release"))

from archives import write_tar, write_zip  # noqa: E402
from check import problems  # noqa: E402
from places import telling  # noqa: E402
from sbom import bill_of, libraries_in  # noqa: E402
from versions import differing  # noqa: E402

needs_ssh = pytest.mark.skipif(shutil.which("ssh-keygen") is None, reason="ssh-keygen is not installed")


def test_the_version_is_the_same_in_all_places():
    assert not differing()


@pytest.fixture
def signed(tmp_path):
    """Creates a folder of two files with their sums, signed, and the file of signers."""
    folder = tmp_path / "release"
    folder.mkdir()
    for name in ("a.whl", "b.deb"):
        (folder / name).write_text(f"what {name} has\n")
    sums = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(folder.iterdir())]
    (folder / "SHA256SUMS").write_text("".join(sums))
    key = tmp_path / "key"
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", key], check=True)
    subprocess.run(["ssh-keygen", "-q", "-Y", "sign", "-f", key, "-n", "contactd-release", folder / "SHA256SUMS"], check=True)
    (tmp_path / "signers").write_text(f"contactd-release {(tmp_path / 'key.pub').read_text()}")
    return folder, tmp_path / "signers"


@needs_ssh
def test_what_was_signed_is_sound(signed):
    assert problems(*signed) == []


@needs_ssh
@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda folder: (folder / "SHA256SUMS.sig").unlink(), "are not signed"),
        (lambda folder: (folder / "a.whl").write_text("other"), "a.whl has been altered"),
        (lambda folder: (folder / "b.deb").unlink(), "b.deb is missing"),
        (lambda folder: (folder / "c.whl").write_text("more"), "c.whl is not listed"),
        (lambda folder: (folder / "SHA256SUMS").write_text((folder / "SHA256SUMS").read_text() + "0  a.whl\n"), "not a signature"),
    ],
)
def test_what_is_not_as_it_was_signed_is_refused(signed, change, sentence):
    change(signed[0])
    assert any(sentence in problem for problem in problems(*signed))


@needs_ssh
def test_the_signature_of_somebody_else_is_refused(signed, tmp_path):
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", tmp_path / "other"], check=True)
    (tmp_path / "signers").write_text(f"contactd-release {(tmp_path / 'other.pub').read_text()}")
    assert any("not a signature" in problem for problem in problems(*signed))


@needs_ssh
def test_a_file_of_signers_that_is_not_there_is_not_taken_for_a_wrong_signature(signed, tmp_path):
    assert problems(signed[0], tmp_path / "nobody")[0].startswith(f"{tmp_path / 'nobody'} is not a file; it must list signers")
    assert problems(tmp_path / "nothing", signed[1]) == [f"{tmp_path / 'nothing'} is not a folder"]


def test_archives_have_the_same_bytes(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    for write, ending in ((write_tar, ".tar.gz"), (write_zip, ".zip")):
        first = write(tmp_path / f"one{ending}", {"b": b"2", "a": b"1"})
        again = write(tmp_path / f"two{ending}", {"a": b"1", "b": b"2"})
        assert first.read_bytes() == again.read_bytes()


def test_an_archive_has_the_names_by_which_linkers_find_its_libraries(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    write_tar(tmp_path / "a.tar.gz", {"lib/libx.so.1.0": b"\x7fELF"}, {"lib/libx.so.1": "libx.so.1.0", "lib/libx.so": "libx.so.1"})
    with tarfile.open(tmp_path / "a.tar.gz") as archive:
        assert archive.getnames() == ["lib/libx.so", "lib/libx.so.1", "lib/libx.so.1.0"]
        assert archive.extractfile("lib/libx.so").read() == b"\x7fELF"


def test_the_bill_lists_what_files_have_inside(tmp_path):
    with zipfile.ZipFile(tmp_path / "x.whl", "w") as archive:
        archive.writestr("x-1.dist-info/METADATA", "Name: x\nRequires-Dist: numpy>=1.24\n\nInside:\n\n- eigen3 3.4.0-5\n- hdf5_1.14.5.orig.tar.gz\n- ducc0-0.42.tar.gz\n")
    assert set(libraries_in(tmp_path / "x.whl")) == {("numpy", ">=1.24"), ("eigen3", "3.4.0-5"), ("hdf5", "1.14.5"), ("ducc0", "0.42")}
    bill = json.loads(bill_of(tmp_path, "1.0.0", "2026-01-01T00:00:00Z"))
    assert (bill["bomFormat"], bill["specVersion"]) == ("CycloneDX", "1.5")
    (inside,) = (one["dependsOn"] for one in bill["dependencies"] if one["ref"] == "x.whl")
    assert {one["bom-ref"] for one in bill["components"]} >= set(inside) >= {"hdf5@1.14.5"}


def test_the_bill_lists_what_a_library_from_pypi_has_inside(tmp_path):
    with zipfile.ZipFile(tmp_path / "x.fmu", "w") as archive:
        archive.writestr("documentation/licenses/sources.txt", "zeromq-4.3.4, in pyzmq-25.1.2.tar.gz, its folder bundled/zeromq\n")
    with zipfile.ZipFile(tmp_path / "x.whl", "w") as archive:
        archive.writestr("x-1.dist-info/METADATA", "Name: x\nRequires-Dist: pyzmq>=24\n\nIts client.\n")
    assert set(libraries_in(tmp_path / "x.fmu")) == {("zeromq", "4.3.4")}
    bill = json.loads(bill_of(tmp_path, "1.0.0", "2026-01-01T00:00:00Z"))
    needed = {one["ref"]: set(one.get("dependsOn", [])) for one in bill["dependencies"]}
    assert len(needed) == len(bill["dependencies"])
    assert needed["x.whl"] == {"pyzmq@>=24"}
    assert needed["pyzmq@>=24"] == {"zeromq@any", "libsodium@any"} <= {one["bom-ref"] for one in bill["components"]}


def test_what_is_inside_and_has_no_version_is_not_passed_over(tmp_path):
    with zipfile.ZipFile(tmp_path / "x.fmu", "w") as archive:
        archive.writestr("documentation/licenses/sources.txt", "zeromq, as it lies there\n")
    with pytest.raises(ValueError, match="x.fmu lists 'zeromq, as it lies there'"):
        list(libraries_in(tmp_path / "x.fmu"))


def test_the_bill_looks_into_the_fmus_of_an_archive(tmp_path):
    with zipfile.ZipFile(tmp_path / "x.fmu", "w") as archive:
        archive.writestr("documentation/licenses/sources.txt", "hdf5_1.14.5.orig.tar.gz\n")
    with zipfile.ZipFile(tmp_path / "x.ssp", "w") as archive:
        archive.write(tmp_path / "x.fmu", "resources/x.fmu")
        archive.writestr("SystemStructure.ssd", "")
    assert set(libraries_in(tmp_path / "x.ssp")) == {("hdf5", "1.14.5")}


def test_binaries_that_name_a_folder_of_the_machine_are_found_wherever_they_are_packed(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    (tmp_path / "apart").mkdir()
    program, text = b"\x7fELF...\0/home/a/sources/x.c\0", b"see /home/a/sources"
    inner = write_zip(tmp_path / "apart" / "inner.fmu", {"binaries/linux64/x.so": program, "documentation/index.html": text})
    folder = tmp_path / "release"
    folder.mkdir()
    write_zip(folder / "x.ssp", {"resources/inner.fmu": inner.read_bytes()})
    write_tar(folder / "y.tar.gz", {"lib/y.so": program, "README": text, "lib/z.dll": b"MZ...sources/x.c"})
    assert telling(folder, ["/home/a/"]) == ["x.ssp: resources/inner.fmu: binaries/linux64/x.so names /home/a/", "y.tar.gz: lib/y.so names /home/a/"]
    assert telling(folder, ["/home/b/"]) == []

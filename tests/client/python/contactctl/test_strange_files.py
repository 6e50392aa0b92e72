"""Tests files with wrong types, excessive sizes or endless contents: each causes a message soon."""

import contextlib
import os
import resource
import socket
import struct
import subprocess
import sys
import threading
import zipfile

import click
import numpy as np
import pytest

from contactctl.files import read_object
from contactd import SavedFileError, TableFileError, load, load_table
from contactd.files.whole import read_whole

BOMB = "a: &a [1,1,1,1,1,1,1,1,1]\n" + "".join(
    f"{name}: &{name} [{','.join(f'*{before}' for _ in range(9))}]\n" for before, name in zip("abcdefghi", "bcdefghij")
)
MERGES = "a: &a {k0: 1}\n" + "".join(
    f"{name}: &{name} {{<<: [{','.join(f'*{before}' for _ in range(9))}], {name}: 1}}\n" for before, name in zip("abcdefghi", "bcdefghij")
)


@pytest.fixture
def file(tmp_path):
    def write(name, content):
        (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
        return str(tmp_path / name)

    return write


@pytest.fixture(autouse=True)
def _little_memory():
    """None of them uses more than this in addition to the tests."""
    with open("/proc/self/statm") as statm:
        before = int(statm.read().split()[1]) * resource.getpagesize()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    yield
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 - max(before, peak) < 400e6


@pytest.fixture(params=["folder", "pipe", "socket", "/dev/zero", "/dev/full", "missing"])
def strange(request, tmp_path):
    """Creates something other than a file in its folder, with the expected message."""
    place = tmp_path / f"{request.param.strip('/').replace('/', '-')}.npy"
    match request.param:
        case "folder":
            place.mkdir()
        case "pipe":
            os.mkfifo(place)
        case "socket":
            with socket.socket(socket.AF_UNIX) as made:
                made.bind(str(place))
        case "missing":
            return place, "No such file or directory"
        case device:
            place.symlink_to(device)
    kinds = {"pipe": "it is a named pipe; it must be a file", "folder": "Is a directory", "socket": "No such device"}
    return place, kinds.get(request.param, "it is a device; it must be a file")


@pytest.mark.parametrize("suffix", [".json", ".yaml", ".npy", ".txt", ".csv", ".npz"])
@pytest.mark.timeout(20)
def test_what_is_no_file_is_refused_at_once(lonely, strange, suffix):
    place, why = strange
    place = place.rename(lonely.folder / f"strange{suffix}") if place.exists() or place.is_symlink() else place.with_suffix(suffix)
    lonely.write("named.json", {"gap": {"array": {"$file": str(place)}}})
    lonely.write("history.json", {"open": {}, "steps": str(place)})
    commands = [("ic", "show", place)] if suffix == ".npz" else [("session", "history.json")] if suffix == ".csv" else [("solve", "named.json")]
    if suffix in (".json", ".yaml"):
        commands = [("solve", place), ("wheelrail", "solve", place), ("session", place), ("study", place), ("ic", "build", place), ("bench", place)]
    for command in commands:
        ended = lonely(*command)
        assert ended.code == 2
        assert ended.out == ""
        assert place.name in ended.err
        assert why in ended.err


@pytest.mark.timeout(20)
def test_keys_and_rows_are_files_too(lonely, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for words in (("keys", "show", "pipe"), ("health", "--server-key", "pipe", "--own-key", "pipe")):
        ended = lonely(*words)
        assert ended.code == 2
        assert "it is a named pipe" in ended.err
    lonely.write("study.json", {"problem": "contact.yaml", "vary": {"approach": [0.01]}})
    for rows in ("pipe", "/dev/zero", str(tmp_path)):
        ended = lonely("study", "study.json", "--rows", rows)
        assert ended.code == 2
        assert rows in ended.err


@pytest.mark.parametrize(
    "text",
    [BOMB, MERGES, "[" + "1," * 300_000 + "1]", "a: &a [*a]\n", "a: &a {b: {<<: *a}}\n"],
    ids=["aliases", "merges", "values", "a circle", "a merged circle"],
)
@pytest.mark.timeout(60)
def test_yaml_that_would_take_all_memory_is_refused(file, text):
    path = file("a.yaml", text)
    with pytest.raises(click.UsageError, match=r"a\.yaml is not valid YAML: (its aliases repeat more than|it has more than|the value that begins in line 1 contains itself)"):
        read_object(path)


def test_aliases_of_moderate_number_are_as_before(file):
    found = read_object(file("a.yaml", "a: &a [1, 2]\nb: [*a, *a]\nc: &c {x: 1}\nd: {<<: *c, y: 2}\n"))
    assert found == {"a": [1, 2], "b": [[1, 2], [1, 2]], "c": {"x": 1}, "d": {"x": 1, "y": 2}}


def test_json_with_too_many_values_is_refused_before_it_is_read(file):
    with pytest.raises(click.UsageError, match="more than 2000000 values"):
        read_object(file("a.json", '{"a": [' + "[]," * 2_000_001 + "[]]}"))


@pytest.mark.parametrize("name", ["a.json", "a.yaml"])
def test_a_document_that_is_too_large_is_refused_with_both_sizes(file, name):
    with open(path := file(name, ""), "wb") as sparse:
        sparse.truncate(1 << 40)
    with pytest.raises(click.UsageError, match=rf"{name} cannot be read: it has {1 << 40} bytes or more, but at most {1 << 25} are read"):
        read_object(path)


def test_standard_input_that_does_not_end_is_refused(lonely):
    with open("/dev/zero") as zero:
        process = lonely.start("solve", "-", stdin=zero)
        _, said = process.communicate(timeout=50)
    assert process.returncode == 2
    assert "Standard input has more than" in said


def test_a_file_that_memory_has_no_room_for_is_refused(tmp_path):
    with (tmp_path / "large").open("wb") as sparse:
        sparse.truncate(1 << 33)
    script = (
        "import resource; from contactd.files.whole import read_whole\n"
        "resource.setrlimit(resource.RLIMIT_AS, (1 << 32, 1 << 32))\n"
        "try:\n    read_whole('large', 1 << 34)\nexcept OSError as error:\n    print(error.strerror)\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    ran = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=50)
    assert ran.stdout == f"it has {1 << 33} bytes or more, which do not fit into memory\n", ran.stderr


@pytest.mark.skipif(not os.access("/proc/kmsg", os.R_OK), reason="not root")
@pytest.mark.timeout(20)
def test_a_file_that_waits_for_the_system_is_not_waited_for():
    with contextlib.suppress(OSError):
        read_whole("/proc/kmsg", 1 << 30)


def npy(shape, type_="<f8", data=b"", version=(1, 0)):
    header = f"{{'descr': '{type_}', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
    length = struct.pack("<H" if version == (1, 0) else "<I", len(header))
    return b"\x93NUMPY" + bytes(version) + length + header + data


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (npy((10**6, 10**6)), "8000000000000 bytes of shape .1000000, 1000000., but 0 follow"),
        (npy((10**30,)), "bytes of shape"),
        (npy((2, 2), data=bytes(24)), "32 bytes of shape .2, 2., but 24 follow"),
        (npy((2, 2), data=bytes(40)), "32 bytes of shape .2, 2., but 40 follow"),
        (npy((-1, -4), data=bytes(32)), "shape .-1, -4."),
        (npy((2,), "<U8", bytes(64)), "its type is"),
        (npy((2,), "<U1000000000"), "its header is not one"),
        (npy((2,), "|O", bytes(16)), "its type is object"),
        (npy((2,), "<c16", bytes(32)), "its type is complex128"),
        (npy((0,), "|V0"), "its type is"),
        (npy("(2", data=bytes(16)), ""),
        (npy((2,), data=bytes(16), version=(3, 0)), "version 3.0"),
        (npy((2,), data=bytes(16), version=(9, 9)), ""),
        (b"\x93NUMPY\x01\x00\xff\xff", ""),
        (b"\x93NUMPY\x02\x00\xff\xff\xff\xff", ""),
        (b"\x93NUMPY", ""),
        (b"", ""),
        (b"\x00" * 1000, ""),
        (b"PK\x03\x04" + bytes(100), "it is an archive"),
    ],
)
@pytest.mark.timeout(20)
def test_an_npy_file_that_lies_is_refused(file, content, why):
    file("gap.npy", content)
    path = file("a.json", '{"gap": {"array": {"$file": "gap.npy"}}}')
    with pytest.raises(click.UsageError, match=rf"a\.json names .*gap\.npy, which contains no array of numbers: .*{why}"):
        read_object(path)


@pytest.mark.parametrize("type_", ["<f8", ">f8", "<f4", "<i8", "|i1", "|b1"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_an_npy_file_of_numbers_is_read(tmp_path, file, type_, order):
    array = np.asarray(np.arange(6).reshape(2, 3) % 2, dtype=type_, order=order)
    np.save(tmp_path / "gap.npy", array)
    found = read_object(file("a.json", '{"gap": {"$file": "gap.npy"}}'))["gap"]
    assert (found == array).all()


@pytest.mark.parametrize(
    "text", ["-30 1.5\n0 0\n", "-30,1.5\n0,0\n", "-30;1.5\n0;0", "-30;1,5\r\n0;0\r\n", "\ufeff-30,1.5\n0,0\n", "y,z\n-30,1.5\n0,0",
             "% rail\n-30\t1.5\n\n0 0 # corner\n", "y (mm);z (mm)\n-30;1,5\n0;0\n"],
)  # fmt: skip
def test_a_text_of_numbers_is_read_however_they_are_divided(file, text):
    file("rail.txt", text)
    assert read_object(file("a.json", '{"points": {"$file": "rail.txt"}}'))["points"].tolist() == [[-30, 1.5], [0, 0]]


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("1 2\n3\n", "line 2 has 1 numbers, but the first has 2"), ("1 2\n3 x\n", "line 2 has 'x' instead of a number"),
        ("a b\n1 2\nc d\n", "line 3 has 'c'"), ("1 a\n", "line 1 has 'a'"), ("# nothing\n", "it has none"), ("a b\n", "it has none"),
        ("1,2;3\n4,5\n", "line 2 has 1 numbers"), ("1\n" + "9" * 200 + "x", "line 2 has '9{40}' in"),
    ],
)  # fmt: skip
def test_a_text_of_other_things_is_refused_with_its_line(file, text, why):
    file("rail.txt", text)
    with pytest.raises(click.UsageError, match=rf"names .*rail\.txt, which contains no array of numbers: {why}"):
        read_object(file("a.json", '{"points": {"$file": "rail.txt"}}'))


@pytest.mark.parametrize("name", ["\\u0000", "a\\u0000b", "x" * 300, "\\ud800"])
def test_a_name_that_no_file_has_is_refused(file, name):
    with pytest.raises(click.UsageError, match="cannot be read|contains no array"):
        read_object(file("a.json", f'{{"points": {{"$file": "{name}"}}}}'))


@pytest.mark.parametrize("name", ["1", "[1]", "{}", "null"])
def test_a_name_that_is_no_text_is_refused(file, name):
    with pytest.raises(click.UsageError, match=r"\$file is .*; it must be the name of a file"):
        read_object(file("a.json", f'{{"points": {{"$file": {name}}}}}'))


@pytest.mark.parametrize("value", ["1e999", "-1e999"])
def test_numbers_beyond_all_are_told_by_field(lonely, value):
    ended = lonely("solve", lonely.write("a.json", f'{{"approach": {value}}}'))
    assert ended.code in (2, 4)
    assert "Traceback" not in ended.err
    lonely.write("steps.csv", f"Fn\n{value}\n")
    ended = lonely("session", lonely.write("history.json", {"open": {}, "steps": "steps.csv"}))
    assert ended.code == 2
    assert "steps.csv: step 1 has Fn" in ended.err


def test_what_a_shell_puts_in_the_place_of_a_file_is_read():
    reading, writing = os.pipe()
    thread = threading.Thread(target=lambda: (os.write(writing, b"abc"), os.close(writing)))
    thread.start()
    try:
        assert read_whole(f"/dev/fd/{reading}", 10) == b"abc"
    finally:
        thread.join()
        os.close(reading)


def archive_of(path, **members):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(f"{name}.npy", content)


@pytest.mark.timeout(20)
def test_tables_that_lie_are_refused(tmp_path):
    archive_of(tmp_path / "lies.npz", array=npy((3, 3, 10**5, 10**5)), pair=npy((), "<U2"))
    archive_of(tmp_path / "bomb.npz", array=npy((3, 3, 1, 10**8 // 9), data=bytes(8 * 9 * (10**8 // 9) // 8)))
    for name in ("lies.npz", "bomb.npz"):
        with pytest.raises(TableFileError, match=f"{name} is not an archive of numpy, or is damaged"):
            load_table(tmp_path / name)


@pytest.mark.timeout(20)
def test_pipes_in_the_place_of_tables_and_solutions_are_refused(tmp_path):
    for name in ("a.npz", "a.txt"):
        os.mkfifo(tmp_path / name)
        with pytest.raises(OSError, match="it is a named pipe; it must be a file"):
            load_table(tmp_path / name)
    pytest.importorskip("h5py")
    os.mkfifo(tmp_path / "solution.h5")
    with pytest.raises((OSError, SavedFileError), match="it is a named pipe"):
        load(tmp_path / "solution.h5")

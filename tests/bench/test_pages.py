"""What ./dev bench --page measures becomes a file, and the file becomes pages."""

import re
import shutil

import pytest

import page_values
import pages
from page_values import of_benchmarks, of_latency, of_many, of_sessions, rows_of_file
from run import ratio

NOW = {"commit": "0123abcd", "machine": "own", "date": "2026-12-01"}
ROWS = [
    {"name": "bench_core.A_p/n:40", "seconds": 2.2e-5},
    {"name": "bench_core.NORM/n:40", "seconds": 4e-4, "A_p": 18.125, "solver_iterations": 6.0},
    {"name": "bench_core.NORM/n:160", "seconds": 6e-3, "A_p": 20.2, "solver_iterations": 7.0},
    {"name": "bench_vehicle.vehicle/full", "seconds": 1.0, "us": 5000.0, "p99_us": 6000.0},
    {"name": "bench_vehicle.vehicle/full_to_1e4", "seconds": 1.0, "us": 3000.0, "p99_us": 3600.0},
    {"name": "bench_fem.failed", "seconds": 0.0, "error_occurred": True, "error_message": "no"},
]
SCALING = "model,elements,us,us_per_element,products,iterations\nshift,4096,1268,0.3096,62.44,7\nshift,10000,3905,0.3905,,8\n"
RECORDED = "page,section,figure\npage.md,cost,1 ms\npage.md,cost,2 | 3.5\n"


@pytest.fixture
def values(tmp_path):
    def of(*keys):
        pages.write(tmp_path / "benchmarks.csv", rows_of_file(dict(of_benchmarks(ROWS, ratio)), list(keys), NOW))
        (tmp_path / "performance.csv").write_text(SCALING)
        (tmp_path / "recorded.csv").write_text(RECORDED)
        return pages.Values(tmp_path)

    return of


def test_a_template_shows_measured_values_with_three_digits(values):
    keys = ["bench_core.NORM/n:40 A_p", "bench_core.NORM/n:160 A_p", "bench_core.A_p/n:40 us"]
    template = "| NORM | {{bench_core.NORM/n:(40,160) A_p}} | {{bench_core.A_p/n:40 us}} us | {{bench_core.NORM/* A_p}} |"
    assert pages.render(template, values(*keys)) == "| NORM | 18.1, 20.2 | 22 us | 18.1 to 20.2 |"


def test_times_have_ratios():
    found = dict(of_benchmarks(ROWS, ratio))
    assert found["bench_vehicle.vehicle/full ms"] == 5
    assert found["bench_vehicle.vehicle/full p99_over_median"] == pytest.approx(1.2)
    assert found["bench_vehicle.vehicle/full_to_1e4 over_full"] == pytest.approx(0.6)
    assert found["bench_core.NORM/n:40 over"] == 18.125
    assert not [key for key in found if key.startswith("bench_fem")]


def test_nothing_is_written_if_a_value_of_the_templates_was_not_measured():
    with pytest.raises(SystemExit, match=r"not measured: bench_core\.NORM/n:320 A_p"):
        rows_of_file(dict(of_benchmarks(ROWS, ratio)), ["bench_core.NORM/n:40 A_p", "bench_core.NORM/n:320 A_p"], NOW)


def test_all_rows_of_one_run_name_its_commit(values):
    shown = values("bench_core.NORM/n:40 A_p", "bench_core.A_p/n:40 us").value("provenance")
    assert shown.splitlines()[2:] == ["| 0123abcd | 2026-12-01 | own | 2 |"]


def test_other_files_have_values_too(values):
    found = values("bench_core.NORM/n:40 A_p")
    assert found.value("scaling.shift/4096 products") == "62.4"
    assert found.value("scaling.shift/* iterations") == "7 to 8"
    assert found.value("recorded page.md#cost 1") == "1 ms"
    assert found.value("recorded page.md#cost 2.2") == "3.5"


@pytest.mark.parametrize("key", ["bench_core.TangCG/n:40 A_p", "scaling.kpec/* us", "recorded page.md#cost 3"])
def test_a_value_that_is_in_no_file_is_an_error(values, key):
    with pytest.raises(KeyError):
        values("bench_core.NORM/n:40 A_p").value(key)


def test_rows_of_programs_have_the_names_and_units_of_the_templates():
    row = {"endpoint": "ipc", "n": 25, "friction": True, "spin": 2000}
    measured = dict(of_latency([{**row, **{part: {"median": 0.5} for part in ("solve", "overhead", "echo", "over_echo")}}]))
    times = {"together": 3e-3, "one_by_one": 4e-3, "solves": 2e-3, "beyond": 1e-4}
    measured |= dict(of_many({"rows": [{"workers": 2, **times}], "two_over_one": 0.6}, [{"workers": 1, "many": 3e-5, "single": 4e-4}]))
    measured |= dict(of_sessions("tcp", {"... again": {"trip": 6e-5}}))
    assert measured["service.ipc/25/shift/spinning added"] == 0.5
    assert measured["many_steps.2 beyond"] == pytest.approx(0.1)
    assert measured["many_solves.1 single"] == pytest.approx(400)
    assert measured["session_steps.tcp/again trip"] == pytest.approx(60)


def test_the_file_has_a_value_for_each_key_of_the_templates():
    names = [f"{row['row']} {row['quantity']}" for row in pages.read(pages.ROOT / "docs" / "benchmarks.csv")]
    assert len(names) == len(set(names))
    assert set(names) == {key for key in pages.needed() if "*" not in key}


@pytest.fixture
def root(tmp_path):
    """The templates and the files of their values."""
    for name in [*pages.TEMPLATES.values(), *(str(path.relative_to(pages.ROOT)) for path in pages.ROOT.glob("docs/*.csv"))]:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(pages.ROOT / name, tmp_path / name)
    shutil.copytree(pages.ROOT / "docs" / "validation", tmp_path / "docs" / "validation")
    return tmp_path


def test_one_run_renews_all_values_and_pages(root, monkeypatch):
    old = pages.read(root / "docs" / "benchmarks.csv")
    measured = {f"{row['row']} {row['quantity']}": float(re.findall(r"[\d.]+", row["value"])[0]) for row in old}
    curves = [
        {"name": f"bench_scaling.{row['model']}/n:{row['elements']}", "elements": row["elements"], "cpu_time": float(row["us"]),
         "time_unit": "us", **({"A_p": float(row["products"]), "solver_iterations": row["iterations"]} if row["products"] else {})}
        for row in pages.read(root / "docs" / "performance.csv")
    ]  # fmt: skip
    monkeypatch.setattr(pages, "provenance", lambda: NOW)
    monkeypatch.setattr(page_values.transforms, "measure", lambda *_: {})
    monkeypatch.setattr(page_values, "by_daemons", lambda *_: iter(measured.items()))
    monkeypatch.setattr(page_values.scaling, "rows_of", lambda *_: curves)
    page_values.write(root / "build" / "production" / "bin", True, [], lambda *_: [], ratio, root)
    for file in ("benchmarks.csv", "performance.csv"):
        assert {row["commit"] for row in pages.read(root / "docs" / file)} == {"0123abcd"}
    page = (root / "docs" / "performance.md").read_text()
    assert f"| 0123abcd | 2026-12-01 | own | {len(measured)} |" in page
    assert "several versions" not in page
    assert len(pages.read(root / "docs" / "benchmarks.csv")) == len(old)


@pytest.mark.parametrize(("value", "shown"), [(560.4, "560"), (1384.2, "1380"), (0.0512, "0.0512"), (6.0, "6"), (1.203, "1.2")])
def test_digits(value, shown):
    assert pages.digits(value) == shown

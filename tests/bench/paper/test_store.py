"""Tests that finished computations are kept when the run is interrupted."""

from contextlib import nullcontext

import pytest

from paper.fem.cases import Case, spec_of
from paper.fem.section import SECTION
from paper.run import compute
from paper.store import ResultStore, StoreInUse


def case(f):
    return Case("table3", "hex", "f", f, 10, spec_of(10, f=f, L_over_h=80))


def result(f):
    errors = {"10": {"zz": {"origin": -f / 1000, "largest": f / 100}}}
    return {"dofs": 1000, "cpu_seconds": 0.5, "errors": errors}


class Interrupted(Exception):
    pass


class FakeBuilder:
    """Counts requests; is interrupted at the request number `ends_at`."""

    def __init__(self, ends_at=None):
        self.asked, self._ends_at = [], ends_at

    def measure(self, spec):
        if len(self.asked) == self._ends_at:
            raise Interrupted
        self.asked.append(spec["ics"]["f"])
        return result(spec["ics"]["f"])


@pytest.fixture
def path(tmp_path):
    return tmp_path / "build" / "results.jsonl"


def test_an_interrupted_run_goes_on_where_it_ended(path):
    cases, first, second = [case(f) for f in (1.2, 1.5, 2)], FakeBuilder(ends_at=2), FakeBuilder()
    with pytest.raises(Interrupted), ResultStore(path, "1") as store:
        compute(cases, store, SECTION, nullcontext(first.measure), lambda line: None)
    with ResultStore(path, "1") as store:
        compute(cases, store, SECTION, nullcontext(second.measure), lambda line: None)
        found = [store.get(item.spec) for item in cases]
    assert (first.asked, second.asked) == ([1.2, 1.5], [2])
    assert found == [result(1.2), result(1.5), result(2)]


def test_a_line_that_was_cut_off_is_computed_again(path):
    with ResultStore(path, "1") as store:
        store.put(case(1.2).spec, result(1.2))
        store.put(case(1.5).spec, result(1.5))
    path.write_bytes(path.read_bytes()[:-20])
    with ResultStore(path, "1") as store:
        assert store.get(case(1.2).spec) == result(1.2)
        assert store.get(case(1.5).spec) is None
        store.put(case(1.5).spec, result(1.5))
    with ResultStore(path, "1") as store:
        assert store.get(case(1.5).spec) == result(1.5)


def test_another_version_computes_anew(path):
    with ResultStore(path, "1") as store:
        store.put(case(1.2).spec, result(1.2))
    with ResultStore(path, "2") as store:
        assert store.get(case(1.2).spec) is None


def test_fresh_forgets(path):
    with ResultStore(path, "1") as store:
        store.put(case(1.2).spec, result(1.2))
    with ResultStore(path, "1", fresh=True) as store:
        assert store.get(case(1.2).spec) is None


def test_results_of_another_build_are_used_and_said_to_be(path):
    with ResultStore(path, "1", "first build") as store:
        store.put(case(1.2).spec, result(1.2))
    reported, builder = [], FakeBuilder()
    with ResultStore(path, "1", "second build") as store:
        compute([case(1.2), case(1.5)], store, SECTION, nullcontext(builder.measure), reported.append)
    assert builder.asked == [1.5]
    assert "1 of them are of another build" in reported[1]


def test_two_runs_do_not_share_a_store(path):
    with ResultStore(path, "1"), pytest.raises(StoreInUse, match="another run"):
        ResultStore(path, "1")


def test_progress_counts_and_names_what_is_left(path):
    reported = []
    with ResultStore(path, "1") as store:
        compute([case(1.2), case(1.2), case(1.5)], store, SECTION, nullcontext(FakeBuilder().measure), reported.append)
    assert len(reported) == 2
    assert reported[0].startswith("[  1/2] table3: hex, f = 1.2") and "left" in reported[0]

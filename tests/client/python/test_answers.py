"""Tests answers as dataclasses, and statuses as exceptions."""

import dataclasses
import sys
from typing import Any

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    Cancelled,
    Client,
    ContactdError,
    ContactProblem,
    DeadlineExceeded,
    FailedPrecondition,
    FemIcs,
    Grid,
    InternalError,
    InvalidArgument,
    Material,
    NotFound,
    Paraboloid,
    ProtocolError,
    ResourceExhausted,
    Rolling,
    Shift,
    StatusError,
    TableIcs,
    TimeoutExpired,
    Unavailable,
    Unimplemented,
    Violation,
)
from contactd.values.answers import read
from contactd.values.generated.evidence import Discretisation, IcEvidence, SolverEvidence
from contactd.values.generated.service import ServerInfo
from contactd.values.solution import ContactSolution, Derivatives, DerivativesOfAnswer
from contactd.values.tables import IcSpec
from support import answers
from support.fake_server import FakeServer

GRID = Grid(3, 2, 1, 1)


def ask(tmp_path, script, question):
    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        return question(client)


def get_table(client):
    return client.get_ic(Material(1, 0), GRID, AnalyticIcs())


def solve(client):
    return client.solve(grid=GRID, upper=Material(1, 0), gap=Paraboloid(1, 1), approach=0.1)


def test_a_table_is_indexed_by_component(tmp_path):
    table = ask(tmp_path, lambda request: [request.result(*answers.table(2, 3))], get_table)
    assert table.array.shape == (3, 3, 2, 3)
    np.testing.assert_array_equal(table["xz"], table.array[0, 2])
    np.testing.assert_array_equal(table["zy"], table.array[2, 1])
    assert table.spec.material == Material(1, 0)
    assert table.spec.ics == AnalyticIcs(body="half_space", load_shape="constant")


@pytest.mark.parametrize("component", ["", "z", "zw", "zzz", "ZZ"])
def test_a_component_that_does_not_exist_is_a_key_error(tmp_path, component):
    table = ask(tmp_path, lambda request: [request.result(*answers.table(2, 3))], get_table)
    with pytest.raises(KeyError, match="not a component"):
        table[component]


def test_a_table_of_another_shape_breaks_the_protocol(tmp_path):
    with pytest.raises(ProtocolError, match="shape"):
        ask(tmp_path, lambda request: [request.result(*answers.table(3, 3))], get_table)


def test_a_solution_has_forces_arrays_and_evidence(tmp_path):
    solution = ask(tmp_path, lambda request: [request.result(*answers.solution(2, 3))], solve)
    assert (solution.Fn, solution.Fx, solution.Fy, solution.Mz) == (9.2, -3.2, 0, 0.5)
    assert solution.approach == 0.02
    assert solution.elements.adhesion == 1
    assert solution.elements.border == 0
    assert solution.warnings == ()
    assert solution.element_division.dtype == np.uint8
    assert solution.pressure.shape == (2, 3)
    assert solution.evidence.tangential.iterations == 7
    assert solution.evidence.ics["lower"].origin == "closed_form"


def solution_with(**fields):
    result, *_ = answers.solution(2, 3)
    for name in ["element_division", "pressure", "traction_x", "traction_y"]:
        result[name] = np.zeros((2, 3))
    return {**result, **fields}


def test_a_solution_without_friction_has_nothing_tangential():
    result = solution_with()
    del result["evidence"]["tangential"]
    solution = read(ContactSolution, result)
    assert solution.evidence.tangential is None
    for name in ["slip_x", "slip_y", "motion", "frictional_work", "frictional_power"]:
        assert getattr(solution, name) is None


def test_a_shift_tells_its_motion_slip_and_work():
    motion = {"rigid_shift": [0.1, 0], "rotation": 0, "duration": 2, "force": [None, -3]}
    slip = np.ones((2, 3))
    result = solution_with(motion=motion, slip_x=slip, slip_y=slip, frictional_work=3, warnings=["Beware."])
    solution = read(ContactSolution, result)
    assert solution.motion == Shift(rigid_shift=(0.1, 0), rotation=0, duration=2, force=(None, -3))
    assert solution.slip_y is slip
    assert (solution.frictional_work, solution.frictional_power) == (3, None)
    assert solution.warnings == ("Beware.",)


def test_rolling_tells_its_creepages():
    motion = {
        "xi": 1e-3, "eta": 0, "phi": 0.5, "chi": 0, "dq": 0.1, "spin_offset": 0, "kind": "transient", "steps": 4,
        "velocity": 2,
    }  # fmt: skip
    solution = read(ContactSolution, solution_with(motion=motion, frictional_power=2.5))
    assert solution.motion == Rolling(xi=1e-3, phi=0.5, dq=0.1, spin_offset=0, kind="transient", steps=4, velocity=2)
    assert solution.frictional_power == 2.5


def test_derivatives_have_a_number_of_each_answer_by_each_input():
    assert read(ContactSolution, solution_with()).derivatives is None
    row = {"xi": 1, "eta": 2.5, "phi": 3, "Fn": 4, "mu": 5}
    shifted = {"rigid_shift": [1, 2], "rotation": 3}
    result = solution_with(derivatives={"Fx": row, "Mz": shifted, "approach": {"Fn": 1e-5}})
    result["evidence"]["derivatives"] = {"iterations": 30, "residual": 1e-6, "converged": True, "seconds": 0.1}
    solution = read(ContactSolution, result)
    assert solution.derivatives == Derivatives(
        Fx=DerivativesOfAnswer(xi=1, eta=2.5, phi=3, Fn=4, mu=5),
        Mz=DerivativesOfAnswer(rigid_shift=(1, 2), rotation=3),
        approach=DerivativesOfAnswer(Fn=1e-5),
    )
    assert solution.evidence.derivatives.iterations == 30


def test_evidence_tells_how_finely_the_contact_is_divided():
    result = solution_with()
    assert read(ContactSolution, result).evidence.discretisation is None
    errors = {"elements_across": 7, "force_error": 0.01, "pmax_error": 0.02, "source": "hertz"}
    result["evidence"]["discretisation"] = errors
    assert read(ContactSolution, result).evidence.discretisation == Discretisation(7, 0.01, 0.02, "hertz")
    result["evidence"]["discretisation"] = {**errors, "source": "estimate", "rolling_error": 0.3}
    assert read(ContactSolution, result).evidence.discretisation == Discretisation(7, 0.01, 0.02, "estimate", 0.3)


def test_a_motion_of_neither_kind_breaks_the_protocol():
    with pytest.raises(ProtocolError, match=r"result\.motion is a str"):
        read(ContactSolution, solution_with(motion="still"))


def test_evidence_tells_of_every_solver_that_ran():
    solver = {"iterations": 3, "residual": 1e-9, "converged": True, "seconds": 0.1}
    result = solution_with(evidence={"normal": solver, "outer": solver, "force": solver, "ics": {}})
    evidence = read(ContactSolution, result).evidence
    assert (evidence.outer.iterations, evidence.force.iterations) == (3, 3)
    assert evidence.ics == {}


def solve_two(client):
    problem = ContactProblem(GRID, Material(1, 0), Paraboloid(1, 1), approach=0.1)
    return client.solve_many([problem, problem.replace(grid=Grid(4, 5, 1, 1))])


def test_of_many_problems_each_has_its_solution_or_its_exception(tmp_path):
    violation = {"field": "grid.nx", "description": "is bad"}
    status = {
        "code": 3, "name": "INVALID_ARGUMENT", "message": "Bad.",
        "details": {"reason": "FIELD_INVALID", "violations": [violation]},
    }  # fmt: skip
    solution, error = ask(tmp_path, lambda r: [r.result(*answers.solutions((2, 3), status))], solve_two)
    assert solution.pressure.shape == (2, 3)
    assert isinstance(error, InvalidArgument)
    assert (error.message, error.reason) == ("Bad.", "FIELD_INVALID")
    assert error.violations == (Violation("grid.nx", "is bad"),)
    _, second = ask(tmp_path, lambda r: [r.result(*answers.solutions(status, (5, 4)))], solve_two)
    assert second.pressure.shape == (5, 4)


@pytest.mark.parametrize(
    "result",
    [{}, {"solutions": []}, {"solutions": [1, 2]}, {"solutions": [{}, {}]},
     {"solutions": [{"status": {"code": 0}}, {"status": {"code": 0}}]}],
)  # fmt: skip
def test_solutions_that_are_none_break_the_protocol(tmp_path, result):
    with pytest.raises(ProtocolError):
        ask(tmp_path, lambda request: [request.result(result)], solve_two)


def test_no_problems_have_no_solutions():
    with Client("ipc:///nowhere") as client:
        assert client.solve_many([]) == []


def test_a_table_of_many_problems_is_sent_once(tmp_path):
    table = TableIcs(np.ones((3, 3, 4, 4)), 1, 1)
    problem = ContactProblem(GRID, gap=Paraboloid(1, 1), Fn=1, ics=table)
    requests = []

    def script(request):
        if request.method == "server.info":
            return [request.result(answers.INFO)]
        requests.append(request)
        return [request.result(*answers.solutions((2, 3), (2, 3)))]

    ask(tmp_path, script, lambda client: client.solve_many([problem, problem.replace(Fn=2)]))
    assert len(requests[0].frames) == 1


def test_answers_of_a_newer_daemon_are_read():
    assert read(ServerInfo, {**answers.INFO, "moon_phase": "full"}).protocol == 1


def test_a_lacking_field_is_named():
    info = {**answers.INFO, "limits": {}}
    with pytest.raises(ProtocolError, match=r"result\.limits lacks max_frame_bytes"):
        read(ServerInfo, info)


def test_a_field_of_the_wrong_type_is_named():
    with pytest.raises(ProtocolError, match=r"result\.counters\.requests is a str"):
        read(ServerInfo, {**answers.INFO, "counters": {"requests": "many"}})


def test_a_field_of_a_part_of_a_list_is_named_by_its_number():
    kind = dataclasses.make_dataclass("kind", [("solvers", tuple[SolverEvidence, ...])])
    told = {"iterations": 3, "residual": 1e-9, "converged": True, "seconds": 1}
    with pytest.raises(ProtocolError, match=r"^The answer's here\.solvers\[1\]\.converged is a str, which"):
        read(kind, {"solvers": [told, {**told, "converged": "yes"}]}, "here")


def test_what_is_read_is_what_its_class_makes():
    told = {"iterations": 3, "residual": 1, "converged": True, "seconds": 0.5}
    made = SolverEvidence(iterations=3, residual=1.0, converged=True, seconds=0.5)
    assert read(SolverEvidence, told) == made
    assert vars(read(SolverEvidence, told)) == vars(made)
    shape = {"elements_across": 7, "force_error": 0.01, "pmax_error": 0.02, "source": "hertz"}
    assert vars(read(Discretisation, shape)) == vars(Discretisation(**shape))
    with pytest.raises(dataclasses.FrozenInstanceError):
        read(Discretisation, shape).source = "estimate"


def test_evidence_of_finite_elements_is_read_to_its_depth():
    case = {"load": "z", "iterations": 13, "residual": 1e-9, "converged": True, "seconds": 1}
    error = {"origin": -1e-3, "largest": 1e-2}
    evidence = read(
        IcEvidence,
        {
            "source": "fem", "version": "0.1.0", "elements": 1840, "dofs": 50361, "processes": 1,
            "seconds": {"total": 4.5}, "load_cases": [case, case],
            "errors": {"xx": error, "yy": error, "zz": error, "scaled_xy": 1e-3, "scaled_xz": 1e-3},
        },
    )  # fmt: skip
    assert evidence.load_cases[1].iterations == 13
    assert evidence.load_cases[1].update is None
    assert evidence.errors.zz.largest == 1e-2
    assert (evidence.warnings, evidence.solver, evidence.mesh, evidence.family_nu) == ((), None, None, ())


def test_evidence_of_an_accuracy_and_a_family_is_read():
    case = {"load": "z", "iterations": 1, "residual": 1e-9, "converged": True, "seconds": 1, "update": 2e-9}
    evidence = read(
        IcEvidence,
        {
            "source": "fem", "load_cases": [case], "errors": {}, "errors_estimated": True, "solver": "direct",
            "warnings": ["Beware."], "mesh": {"mesh": "hex", "order": 4, "L_over_h": 40, "solver": "auto"},
            "family_nu": [0, 0.245, 0.49], "interpolation_error": 1e-6,
        },
    )  # fmt: skip
    assert evidence.load_cases[0].update == 2e-9
    assert evidence.errors is None
    assert evidence.errors_estimated
    assert evidence.warnings == ("Beware.",)
    assert evidence.solver == "direct"
    assert evidence.mesh == FemIcs(mesh="hex", order=4, L_over_h=40, solver="auto")
    assert evidence.family_nu == (0, 0.245, 0.49)
    assert evidence.interpolation_error == 1e-6


def test_a_spec_of_finite_elements_is_read_as_it_was_asked_for():
    ics = {"source": "fem", "body": "block", "accuracy": 1e-3, "any_nu": True, "L_over_h": 20}
    grid = {"nx": 2, "ny": 2, "dx": 1, "dy": 1}
    spec = read(IcSpec, {"material": {"G": 1, "nu": 0}, "grid": grid, "ics": ics})
    assert spec.ics == FemIcs(body="block", accuracy=1e-3, any_nu=True, L_over_h=20)


@pytest.mark.parametrize(
    ("code", "kind"),
    [
        (1, Cancelled),
        (3, InvalidArgument),
        (4, DeadlineExceeded),
        (5, NotFound),
        (8, ResourceExhausted),
        (9, FailedPrecondition),
        (12, Unimplemented),
        (13, InternalError),
        (14, Unavailable),
    ],
)
def test_every_status_has_its_exception(tmp_path, code, kind):
    with pytest.raises(kind) as caught:
        ask(tmp_path, lambda request: [request.failure(code, "Not today.", reason="WHY")], Client.health)
    assert type(caught.value) is kind
    assert caught.value.code == code
    assert caught.value.reason == "WHY"
    assert str(caught.value) == f"Not today. ({kind.name}, WHY)"


def test_a_status_nobody_knows_is_an_unknown_error(tmp_path):
    with pytest.raises(StatusError, match="UNKNOWN"):
        ask(tmp_path, lambda request: [request.failure(99, "?")], Client.health)


def test_a_bad_request_names_its_fields(tmp_path):
    violations = [{"field": "grid.nx", "description": "is 0; it must be positive"}]
    with pytest.raises(InvalidArgument) as caught:
        ask(tmp_path, lambda request: [request.failure(3, "Bad.", violations=violations)], Client.health)
    assert caught.value.violations == (Violation("grid.nx", "is 0; it must be positive"),)


def test_a_full_queue_says_when_to_try_again(tmp_path):
    with pytest.raises(ResourceExhausted) as caught:
        ask(tmp_path, lambda request: [request.failure(8, "Full.", retry_delay_ms=1500)], Client.health)
    assert caught.value.retry_delay == 1.5


def test_deadlines_of_both_sides_are_timeouts():
    assert issubclass(DeadlineExceeded, TimeoutExpired)
    assert issubclass(DeadlineExceeded, StatusError)
    assert issubclass(TimeoutExpired, ContactdError)
    assert issubclass(TimeoutExpired, TimeoutError)


@pytest.mark.skipif(sys.version_info < (3, 12), reason="type statements came with Python 3.12")
def test_types_of_arrays_may_have_names():
    """The result is as in newer versions of numpy."""
    names: dict[str, Any] = {"np": np}
    exec("type Numbers[T: np.generic] = np.ndarray[tuple[int, ...], np.dtype[T]]", names)
    kind = dataclasses.make_dataclass("kind", [("a", names["Numbers"][np.float64]), ("b", names["Numbers"][np.uint8] | None)])
    array = np.zeros(3)
    assert read(kind, {"a": array, "b": None}).a is array
    assert read(kind, {"a": array, "b": array}).b is array
    with pytest.raises(ProtocolError, match=r"result\.a is a int"):
        read(kind, {"a": 1, "b": None})

"""Tests input files of the CONTACT program: their text in a request, their cases in answers."""

from conformance.wire import INVALID_ARGUMENT, NOT_FOUND, OK

CASE = "{}200100\n022020\n000001\n999 20 25 1 1e-5\n1. 0 0 0\n.3 .3\n.28 .28 1. 1.\n-3\n2 2 1. 1. 1.1\n"


def test_cases_come_in_pages(peer):
    text = CASE.format("3 MODULE\n") * 3 + "0 MODULE\n"
    numbers, first = [], 0
    while first is not None:
        reply = peer.ask("contact_file.read", {"text": text, "first": first, "count": 2})
        assert reply.code == OK
        numbers.append([case["number"] for case in reply.result["cases"]])
        first = reply.result.get("next")
    assert numbers == [[1, 2], [3]]
    assert reply.result["warnings"] == reply.result["errors"] == []


def test_a_case_has_its_digits_and_values(peer):
    (case,) = peer.ask("contact_file.read", {"text": CASE.format("3 5 2\n") + "0"}).result["cases"]
    assert (case["line"], case["module"], case["reid"], case["cpid"]) == (2, 3, 5, 2)
    assert case["digits"]["C"] == 2
    assert case["values"]["SCALE"] == 1.1
    assert case["friction"] == [{"FSTAT": 0.3, "FKIN": 0.3}]
    assert "friction" in case["read"]


def test_what_is_wrong_stands_in_the_answer(peer):
    reply = peer.ask("contact_file.read", {"text": "3 MODULE\nabc\n"})
    assert reply.code == OK
    assert "line 2, column 1" in reply.result["cases"][0]["errors"][0]


def test_what_is_no_text_is_refused(peer):
    reply = peer.ask("contact_file.read", {"text": "3 MODULE\0", "name": "a.inp"})
    assert (reply.code, reply.fields) == (INVALID_ARGUMENT, ["a.inp"])


def test_slices_are_answered_with_their_features(peer):
    text = "0.5 1000\n2\n3 0 0\n2\n0 'a.prr'\n1 'b.prr'\n0 0 5 999\n1 -1 5 999\n"
    result = peer.ask("contact_file.slices", {"text": text}).result
    assert [one["u"] for one in result["slices"]] == [500, 1500]
    assert [one["features"] for one in result["slices"]] == [[0, 5, 999], [-1, 5, 999]]
    assert result["is_approximated"]
    assert result["slices"][1]["file"] == "b.prr"


def test_a_list_of_slices_that_does_not_fit_is_refused_by_line(peer):
    reply = peer.ask("contact_file.slices", {"text": "0 1\ntwo\n", "name": "a.slcs"})
    assert reply.code == INVALID_ARGUMENT
    assert reply.fields[0].startswith("a.slcs, line 2, column 1")


def test_a_run_answers_by_the_names_of_contact_and_continues(peer):
    text = CASE.format("3 MODULE\n") * 2 + "0 MODULE\n"
    reply = peer.ask("contact_file.run", {"text": text, "seconds": 1e-9, "fields": []})
    assert reply.code == OK
    (first,) = reply.result["cases"]
    assert (first["status"], first["number"]) == ("solved", 1)
    assert abs(first["numbers"]["FN"] - 1) < 1e-6
    assert set(first["patches"][0]["arrays"]) >= {"IGS", "H", "MU", "PN", "PX", "PY"}
    assert "pressure" not in first["contact"]
    rest = peer.ask("contact_file.run", {"run": reply.result["run"], "arrays": False})
    assert [case["number"] for case in rest.result["cases"]] == [2]
    assert "arrays" not in rest.result["cases"][0]["patches"][0]
    assert "run" not in rest.result
    again = peer.ask("contact_file.run", {"run": reply.result["run"]})
    assert (again.code, again.reason) == (NOT_FOUND, "RUN_UNKNOWN")


def test_a_run_does_not_open_files(peer):
    case = CASE.format("3 MODULE\n").replace("022020", "029020").replace("\n.28 .28", "\n'/etc/passwd'\n.28 .28")
    (wrong,) = peer.ask("contact_file.run", {"text": case + "0"}).result["cases"]
    assert wrong["status"] == "wrong"
    assert wrong["sentence"] == 'The file "/etc/passwd" cannot be read: its content was not given.'


def test_a_run_continues_with_its_own_input(peer):
    reply = peer.ask("contact_file.run", {"run": "0", "cases": [1]})
    assert (reply.code, reply.fields) == (INVALID_ARGUMENT, ["cases"])
    reply = peer.ask("contact_file.run", {"text": "0", "cases": [2, 1]})
    assert (reply.code, reply.fields) == (INVALID_ARGUMENT, ["cases"])


def test_a_converted_case_is_what_contact_solve_takes(peer):
    (case,) = peer.ask("contact_file.convert", {"text": CASE.format("3 MODULE\n") + "0"}).result["cases"]
    assert (case["status"], case["continues"]) == ("read", False)
    reply = peer.ask("contact.solve", case["contact"])
    assert reply.code == OK
    assert abs(reply.result["forces"]["Fn"] - 1) < 1e-6

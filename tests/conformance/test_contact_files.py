"""Input files of the CONTACT program: their text in a request, their cases in answers."""

from conformance.wire import INVALID_ARGUMENT, OK

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

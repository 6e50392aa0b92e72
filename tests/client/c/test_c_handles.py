"""Compilers refuse handles of the wrong kind. They accept pointers to void, as sources from before typed handles have."""

from __future__ import annotations

import re

import pytest

from support.c_programs import ROOT, STRICT, run

INCLUDE = ROOT / "client" / "c" / "include"
COMPILERS = {"C": ("cc", "-xc", *STRICT), "C++": ("c++", "-xc++", "-std=c++11", *STRICT[1:])}
BODY = """{0}
#include <contactd.h>
int32_t call(contactd_connection* connection, contactd_contact* contact, contactd_wheel* wheel, void* any, const void* one);
int32_t call(contactd_connection* connection, contactd_contact* contact, contactd_wheel* wheel, void* any, const void* one) {{
    (void)connection, (void)contact, (void)wheel, (void)any, (void)one;
    return {1};
}}
"""
HEADER = (INCLUDE / "contactd.h").read_text()
CALLS = dict(re.findall(r"CONTACTD_API [^(]*?(contactd_\w+)\(((?:contactd_handle|contactd_any_handle) handle[^)]*)\)", HEADER))


def compiled(tmp_path, language, statement, first=""):
    source = tmp_path / "call.source"
    source.write_text(BODY.format(first, statement))
    return run(*COMPILERS[language], f"-I{INCLUDE}", "-fsyntax-only", source)


def called(name: str, handle: str) -> str:
    """Returns a call that is valid except for its handle, as a number."""
    values = {"double": "1", "int32_t": "1", "const char*": '"a"', "char*": "0", "double*": "0", "const double*": "0", "int32_t*": "0"}
    others = [values[re.sub(r" ?\w+$", "", parameter)] for parameter in CALLS[name].split(", ")[1:]]
    return f"({name}({', '.join([handle, *others])}) ? 1 : 0)"


@pytest.mark.parametrize("language", COMPILERS)
def test_every_function_of_several_kinds_refuses_other_pointers(tmp_path, language):
    assert len(CALLS) == 21
    for name, parameters in CALLS.items():
        wrong = ["&contact", '"Fn"', *([] if "any" in parameters else ["connection"])]
        answer = compiled(tmp_path, language, " + ".join(called(name, handle) for handle in wrong))
        errors = re.findall(r"error: (.*)", answer.stderr)
        assert len(errors) == len(wrong), answer.stderr
        assert all(re.search("incompatible type|deleted function", error) for error in errors), answer.stderr


@pytest.mark.parametrize("language", COMPILERS)
@pytest.mark.parametrize("first", ["", "#define CONTACTD_UNTYPED_HANDLES"])
def test_every_function_of_several_kinds_accepts_its_kinds_and_pointers_to_void(tmp_path, language, first):
    handles = {name: ["contact", "wheel", "any", "0", *(["connection", "one"] if "any" in CALLS[name] else [])] for name in CALLS}
    statement = " + ".join(called(name, handle) for name, kinds in handles.items() for handle in kinds)
    answer = compiled(tmp_path, language, statement, first)
    assert answer.returncode == 0, answer.stderr


@pytest.mark.parametrize("language", COMPILERS)
@pytest.mark.parametrize("call", ["contactd_step(wheel)", "contactd_wheel_solve(contact)", "contactd_close(contact)"])
def test_functions_of_one_kind_refuse_the_others(tmp_path, language, call):
    assert "error: " in compiled(tmp_path, language, call).stderr


def test_a_template_takes_the_address_of_a_function_with_untyped_handles(tmp_path):
    first = "#define CONTACTD_UNTYPED_HANDLES\ntemplate <class F> int take(F* function, void* handle) { return function(handle); }"
    answer = compiled(tmp_path, "C++", "take(contactd_step_again, any)", first)
    assert answer.returncode == 0, answer.stderr

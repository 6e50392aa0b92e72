// Lists every function that takes a contact, with valid arguments.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "c_contact.hpp"

using Call = std::function<std::int32_t(contactd_contact*)>;

/// Holds the variables that the calls below read and write.
struct Arguments {
    double in[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, out[9] = {};
    std::int32_t number = 0;
    char text[8] = {};
};

/// Maps names of functions to calls, including those of fields, which also take wheels; `a` outlives them.
inline std::map<std::string, Call> every_call(Arguments& a) {
    using C = contactd_contact*;
    double* const out = a.out;
    std::int32_t* const n = &a.number;
    return {
        {"contactd_free", [](C c) { return contactd_free(c); }},
        {"contactd_start", [](C c) { return contactd_start(c); }},
        {"contactd_step", [](C c) { return contactd_step(c); }},
        {"contactd_step_again", [](C c) { return contactd_step_again(c); }},
        {"contactd_cancel", [](C c) { return contactd_cancel(c); }},
        {"contactd_save", [=](C c) { return contactd_save(c, n); }},
        {"contactd_restore", [](C c) { return contactd_restore(c, 1); }},
        {"contactd_forget", [](C c) { return contactd_forget(c, 1); }},
        {"contactd_set_step_timeout", [](C c) { return contactd_set_step_timeout(c, 10); }},
        {"contactd_set_table", [&a](C c) { return contactd_set_table(c, "ics", 1, 1, 1, 1, a.in, 9); }},
        {"contactd_get_frames", [=](C c) { return contactd_get_frames(c, "lower", out, out + 2, out + 4, 2); }},
        {"contactd_set", [](C c) { return contactd_set(c, "Fn", 1); }},
        {"contactd_set_word", [](C c) { return contactd_set_word(c, "model", "full"); }},
        {"contactd_set_array", [&a](C c) { return contactd_set_array(c, "gap.array", a.in, 4); }},
        {"contactd_clear", [](C c) { return contactd_clear(c, "friction"); }},
        {"contactd_get", [=](C c) { return contactd_get(c, "pmax", out); }},
        {"contactd_get_word", [&a](C c) { return contactd_get_word(c, "ics.upper.origin", a.text, 8); }},
        {"contactd_get_array", [=](C c) { return contactd_get_array(c, "forces", out, 4); }},
        {"contactd_length", [=](C c) { return contactd_length(c, "forces", n); }},
        {"contactd_want", [](C c) { return contactd_want(c, "pressure", 1); }},
        {"contactd_path", [=](C c) { return contactd_path(c, "Fn", n); }},
        {"contactd_set_at", [](C c) { return contactd_set_at(c, 0, 1); }},
        {"contactd_get_at", [=](C c) { return contactd_get_at(c, 0, out); }},
        {"contactd_read_profile",
         [](C c) { return contactd_read_profile(c, "ics.section.profile_section.profile", "none.prr"); }},
    };
}

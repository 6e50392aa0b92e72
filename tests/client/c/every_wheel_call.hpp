// Lists every function that takes a wheel on its rail, with valid arguments.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "c_contact.hpp"

using WheelCall = std::function<std::int32_t(contactd_wheel*)>;

/// Holds the variables that the calls below read and write.
struct WheelArguments {
    double in[6] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, out[6] = {};
    std::int32_t number = 0;
    char text[8] = {};
};

/// Maps names of functions to calls, including those of fields, which also take contacts; `a` outlives them.
inline std::map<std::string, WheelCall> every_wheel_call(WheelArguments& a) {
    using W = contactd_wheel*;
    return {
        {"contactd_wheel_free", [](W w) { return contactd_wheel_free(w); }},
        {"contactd_read_profile", [](W w) { return contactd_read_profile(w, "setup.rail", "none.prr"); }},
        {"contactd_wheel_solve", [](W w) { return contactd_wheel_solve(w); }},
        {"contactd_wheel_solve_wheelset", [](W w) { return contactd_wheel_solve_wheelset(w, w); }},
        {"contactd_step_again", [](W w) { return contactd_step_again(w); }},
        {"contactd_save", [&a](W w) { return contactd_save(w, &a.number); }},
        {"contactd_restore", [](W w) { return contactd_restore(w, 1); }},
        {"contactd_forget", [](W w) { return contactd_forget(w, 1); }},
        {"contactd_wheel_cancel", [](W w) { return contactd_wheel_cancel(w); }},
        {"contactd_wheel_set_timeout", [](W w) { return contactd_wheel_set_timeout(w, 0.1); }},
        {"contactd_set", [](W w) { return contactd_set(w, "state.Fz", 0.1); }},
        {"contactd_set_word", [](W w) { return contactd_set_word(w, "setup.side", "left"); }},
        {"contactd_set_array", [&a](W w) { return contactd_set_array(w, "state.velocity", a.in, 6); }},
        {"contactd_clear", [](W w) { return contactd_clear(w, "state.Fz"); }},
        {"contactd_get", [&a](W w) { return contactd_get(w, "z", a.out); }},
        {"contactd_get_word", [&a](W w) { return contactd_get_word(w, "warnings[0]", a.text, 8); }},
        {"contactd_get_array", [&a](W w) { return contactd_get_array(w, "forces.track", a.out, 6); }},
        {"contactd_length", [&a](W w) { return contactd_length(w, "forces.track", &a.number); }},
        {"contactd_want", [](W w) { return contactd_want(w, "pressure", 1); }},
        {"contactd_path", [&a](W w) { return contactd_path(w, "state.Fz", &a.number); }},
        {"contactd_set_at", [](W w) { return contactd_set_at(w, 0, 0.1); }},
        {"contactd_get_at", [&a](W w) { return contactd_get_at(w, 0, a.out); }},
    };
}

/// Creates a wheel that frees itself.
class WheelHandle {
   public:
    explicit WheelHandle(contactd_connection* place) { require_ok(contactd_wheel_new(place, &handle_), place); }
    ~WheelHandle() { contactd_wheel_free(handle_); }
    WheelHandle(const WheelHandle&) = delete;
    WheelHandle& operator=(const WheelHandle&) = delete;
    operator contactd_wheel*() const { return handle_; }

   private:
    contactd_wheel* handle_ = nullptr;
};

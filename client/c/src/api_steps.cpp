// Implements contactd.h: steps and states of contacts and wheels.
#include "api_boundary.hpp"

using namespace contactd::c;

std::int32_t contactd_step_again(void* handle) {
    return with_any(handle, []<class Object>(Object& stepping) {
        if constexpr (std::is_same_v<Object, Wheel>)
            stepping.solve(Wheel::Which::again);
        else
            stepping.step(Contact::Which::again);
    });
}

std::int32_t contactd_save(void* handle, std::int32_t* state) {
    return with_any(handle, [&](auto& saved) {
        given(state, "state");
        *state = saved.save();
    });
}

std::int32_t contactd_restore(void* handle, std::int32_t state) {
    return with_any(handle, [&](auto& restored) { restored.restore(state); });
}

std::int32_t contactd_forget(void* handle, std::int32_t state) {
    return with_any(handle, [&](auto& forgetting) { forgetting.forget(state); });
}

// Connects FMI's C functions and an instance: converts exceptions to a status and a sentence in the log.
#pragma once

#include <new>

#include "instance/instance.hpp"
#include "live.hpp"

namespace contactd::fmu {

/// Returns the texts of a C array without NULL entries.
inline std::vector<std::string> texts_of(const char* const* texts, std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t k = 0; texts != nullptr && k < count; ++k)
        if (texts[k] != nullptr) all.emplace_back(texts[k]);
    return all;
}

/// Returns an array argument. Throws Failure for NULL unless it is empty.
template <class Value>
std::span<Value> given(Value* values, std::size_t count, const char* name) {
    if (values == nullptr && count > 0) throw Failure(std::string(name) + " is NULL.");
    return {values, count};
}

/// Throws Failure for a pointer that is NULL.
template <class Value>
Value& given(Value* value, const char* name) {
    if (value == nullptr) throw Failure(std::string(name) + " is NULL.");
    return *value;
}

/// Holds a state that an importer holds.
inline State& state_of(void* state) {
    if (state == nullptr) throw Failure("The FMU state is NULL.");
    State* const found = Live<State>::all().find(state);
    if (found == nullptr) throw Failure("The FMU state is invalid: it was freed, or belongs to another FMU.");
    return *found;
}

/// Replaces the contents of `*place`, which may be an earlier state, or null.
inline void hand_over(std::unique_ptr<State> state, void** place) {
    if (place == nullptr) throw Failure("The place of the FMU state is NULL.");
    Live<State>::all().take(*place);
    *place = Live<State>::all().add(std::move(state));
}

inline void free_state(void** place) {
    if (place == nullptr || *place == nullptr) return;
    state_of(*place);
    Live<State>::all().take(*place);
    *place = nullptr;
}

/// Returns the status of `body` with the instance of `handle`.
template <class Body>
Status guarded(void* handle, const Body& body) noexcept {
    Instance* instance = nullptr;
    try {
        instance = Live<Instance>::all().find(handle);
        if (instance == nullptr) return Status::error;  // invalid handle: freed, or never created
        try {
            body(*instance);
            return Status::ok;
        } catch (const Failure& failure) {
            instance->tell(failure.status, Category::errors, failure.what());
            return failure.status;
        } catch (const std::bad_alloc&) {
            instance->tell(Status::error, Category::errors, "There is not enough memory.");
        } catch (const std::exception& error) {
            instance->tell(Status::error, Category::errors, error.what());
        }
    } catch (...) {  // an exception of the importer's own log
    }
    return Status::error;
}

}  // namespace contactd::fmu

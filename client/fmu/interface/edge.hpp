// Between FMI's functions in C and an instance: no exception leaves, and each becomes a status and a sentence in the
// log.
#pragma once

#include <new>

#include "instance/instance.hpp"

namespace contactd::fmu {

/// Of the categories in an array of C; NULL among them is left out.
inline std::vector<std::string> texts_of(const char* const* texts, std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t k = 0; texts != nullptr && k < count; ++k)
        if (texts[k] != nullptr) all.emplace_back(texts[k]);
    return all;
}

/// What a function is given as an array. Throws Failure for NULL unless it is empty.
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

/// The status of what `body` does with the instance.
template <class Body>
Status guarded(Instance* instance, const Body& body) noexcept {
    if (instance == nullptr) return Status::error;
    try {
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
    } catch (...) {  // of the importer's own log
    }
    return Status::error;
}

}  // namespace contactd::fmu

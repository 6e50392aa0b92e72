// Wraps handles of contactd.h so that they free themselves, and converts its codes to failures.
#pragma once

#include <contactd.h>

#include <memory>
#include <string>
#include <string_view>

#include "model.hpp"

namespace contactd::fmu {

/// Throws Failure with the library's message unless `code` is CONTACTD_OK. Steps that did not converge are discarded.
void check(std::int32_t code, const void* handle);
/// Does the same, but returns false for CONTACTD_NOT_FOUND, otherwise true.
bool found(std::int32_t code, const void* handle);

/// Sets a field of a contact or a wheel by its path. Throws Failure.
void set_field(void* handle, const std::string& path, double value);
void set_keyword(void* handle, const std::string& path, std::string_view keyword);
/// Returns a result, or 0 if the solution does not have it.
double read_field(void* handle, const std::string& path);

struct Closes {
    void operator()(contactd_connection* connection) const { contactd_close(connection); }
    void operator()(contactd_contact* contact) const { contactd_free(contact); }
    void operator()(contactd_wheel* wheel) const { contactd_wheel_free(wheel); }
};
using ConnectionHandle = std::unique_ptr<contactd_connection, Closes>;
using ContactHandle = std::unique_ptr<contactd_contact, Closes>;
using WheelHandle = std::unique_ptr<contactd_wheel, Closes>;

/// Connects to `endpoint`, or in process, with the limits and keys in the values. `tell` must outlive its
/// handles.
ConnectionHandle opened(const Values& values, Tell& tell);

}  // namespace contactd::fmu

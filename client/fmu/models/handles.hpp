// Handles of contactd.h that give themselves back, and its codes as failures.
#pragma once

#include <contactd.h>

#include <memory>
#include <string>
#include <string_view>

#include "model.hpp"

namespace contactd::fmu {

/// Throws Failure with the sentence of the library unless `code` is CONTACTD_OK. What did not converge is discarded.
void check(std::int32_t code, const void* handle);
/// The same, and whether there is something: false for CONTACTD_NOT_FOUND.
bool found(std::int32_t code, const void* handle);

/// Sets a field of a contact or a wheel by its path. Throws Failure.
void set_field(void* handle, const std::string& path, double value);
void set_keyword(void* handle, const std::string& path, std::string_view keyword);
/// Returns a result, or 0 where the solution does not have it.
double read_field(void* handle, const std::string& path);

struct Closes {
    void operator()(contactd_connection* connection) const { contactd_close(connection); }
    void operator()(contactd_contact* contact) const { contactd_free(contact); }
    void operator()(contactd_wheel* wheel) const { contactd_wheel_free(wheel); }
};
using ConnectionHandle = std::unique_ptr<contactd_connection, Closes>;
using ContactHandle = std::unique_ptr<contactd_contact, Closes>;
using WheelHandle = std::unique_ptr<contactd_wheel, Closes>;

/// Where `endpoint` says, or in process; with the limits and keys of the values. `tell` must outlive what is made with
/// it.
ConnectionHandle opened(const Values& values, Tell& tell);

}  // namespace contactd::fmu

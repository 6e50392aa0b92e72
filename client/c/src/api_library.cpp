// Implements contactd.h: the library, and its last failures.
#include <exception>
#include <string>

#include "api_boundary.hpp"
#include "creep_tables.hpp"

namespace contactd::c {
namespace {

/// See contactd_last_code.
Failure last_failure_of(const void* handle) {
    const auto contact = contacts().find_any(handle);
    const auto wheel = wheels().find_any(handle);
    const auto connection = connections().find_any(handle);
    const bool table = creep_tables().holds(handle);  // Tables keep failures in the thread of the call only.
    if (const Failure* mine = kept_failure(contact || wheel || connection || table ? handle : nullptr)) return *mine;
    if (table) return {};
    return contact ? contact->last_failure() : wheel ? wheel->last_failure() : connection->last_failure();
}

/// Returns a text that is valid until the next call with this `place`, which belongs to the thread.
const char* held(std::string& place, const void* handle, std::string Failure::* text) noexcept {
    try {
        place = last_failure_of(handle).*text;
        return place.c_str();
    } catch (...) {
        return "";
    }
}

}  // namespace
}  // namespace contactd::c

using namespace contactd::c;

const char* contactd_version(void) {
    return CONTACTD_VERSION;
}

std::int32_t contactd_version_number(void) {
    return 10000 * CONTACTD_VERSION_MAJOR + 100 * CONTACTD_VERSION_MINOR + CONTACTD_VERSION_PATCH;
}

std::int32_t contactd_has_local(void) {
    return has_local_backend() ? 1 : 0;
}

const char* contactd_code_name(std::int32_t code) {
    return contactd::name_of(static_cast<contactd::StatusCode>(code)).data();  // a literal
}

std::int32_t contactd_last_code(const void* handle) {
    try {
        return last_failure_of(handle).code;
    } catch (...) {
        return CONTACTD_RESOURCE_EXHAUSTED;
    }
}

const char* contactd_last_error(const void* handle) {
    thread_local std::string place;
    return held(place, handle, &Failure::sentence);
}

const char* contactd_last_field(const void* handle) {
    thread_local std::string place;
    return held(place, handle, &Failure::field);
}

const char* contactd_last_reason(const void* handle) {
    thread_local std::string place;
    return held(place, handle, &Failure::reason);
}

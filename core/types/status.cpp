#include "contactd/status.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace contactd {
namespace {

constexpr std::array<std::string_view, 17> names{
    "OK",        "CANCELLED",       "UNKNOWN",           "INVALID_ARGUMENT",   "DEADLINE_EXCEEDED",
    "NOT_FOUND", "ALREADY_EXISTS",  "PERMISSION_DENIED", "RESOURCE_EXHAUSTED", "FAILED_PRECONDITION",
    "ABORTED",   "OUT_OF_RANGE",    "UNIMPLEMENTED",     "INTERNAL",           "UNAVAILABLE",
    "DATA_LOSS", "UNAUTHENTICATED",
};

}  // namespace

std::string_view name_of(StatusCode code) {
    const auto index = static_cast<std::size_t>(code);
    return index < names.size() ? names[index] : names[2];
}

StatusCode code_named(std::string_view name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) throw std::out_of_range("There is no status " + std::string(name) + ".");
    return static_cast<StatusCode>(at - names.begin());
}

StatusError::StatusError(StatusCode code, std::string_view reason, std::string message)
    : StatusError(Status{code, std::move(message), std::string(reason), {}, 0}) {}

}  // namespace contactd

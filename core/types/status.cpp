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

StatusError invalid_field(std::string field, const std::string& problem, std::string_view why) {
    Status status{StatusCode::invalid_argument, field + " " + problem, std::string(why), {}, 0};
    status.violations.push_back({std::move(field), problem});
    return StatusError(std::move(status));
}

Status status_of(const std::exception& error) {
    if (const auto* known = dynamic_cast<const StatusError*>(&error)) return known->status();
    if (const auto* invalid = dynamic_cast<const InvalidArgument*>(&error))
        return invalid_field(invalid->field(), invalid->problem()).status();
    if (dynamic_cast<const Cancelled*>(&error))
        return {StatusCode::cancelled, error.what(), std::string(reason::job_cancelled), {}, 0};
    if (dynamic_cast<const StoreError*>(&error))
        return {StatusCode::failed_precondition, error.what(), std::string(reason::store_unusable), {}, 0};
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return {StatusCode::resource_exhausted,
                "The memory is insufficient for this request.",
                std::string(reason::limit_exceeded),
                {},
                0};
    return {StatusCode::internal, error.what(), std::string(reason::unexpected), {}, 0};
}

}  // namespace contactd

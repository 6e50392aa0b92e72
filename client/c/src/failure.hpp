// Describes failures of the C interface: exceptions become a code, a message, a field and a reason.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "contactd/status.hpp"

namespace contactd::c {

struct Failure {
    std::int32_t code = 0;
    std::string sentence, field, reason;
};

/// Names reasons of the library, in addition to those of the daemon.
inline constexpr std::string_view concurrent_use = "CONCURRENT_USE", wrong_order = "WRONG_ORDER",
                                  no_handle = "NO_HANDLE", no_connection = "NO_CONNECTION", no_result = "NO_RESULT";

/// Returns the failure for the current exception.
Failure current_failure() noexcept;

/// Stores a failure as the last one of this thread, with its handle (null: none).
void keep_failure(const void* handle, Failure failure) noexcept;
/// Returns the last failure of this thread if it concerns `handle`, or any handle if that is null; otherwise null.
const Failure* kept_failure(const void* handle) noexcept;

}  // namespace contactd::c

// Failures as the C interface tells them: exceptions become a code, a sentence, a field and a reason.
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

/// Reasons of the library itself, beside the daemon's.
inline constexpr std::string_view concurrent_use = "CONCURRENT_USE", wrong_order = "WRONG_ORDER",
                                  no_handle = "NO_HANDLE", no_connection = "NO_CONNECTION", no_result = "NO_RESULT";

/// Returns the failure that the exception is which is being handled.
Failure current_failure() noexcept;

/// Keeps a failure as the last one of this thread, of the handle that it happened with (null: of none).
void keep_failure(const void* handle, Failure failure) noexcept;
/// The last failure of this thread if it happened with `handle`, or with any when that is null; else null.
const Failure* kept_failure(const void* handle) noexcept;

}  // namespace contactd::c

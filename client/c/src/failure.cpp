#include "failure.hpp"

#include <exception>
#include <new>
#include <utility>

#include "contactd/client/errors.hpp"

namespace contactd::c {
namespace {

Failure of(StatusCode code, const std::exception& error, std::string_view why, std::string field = "") {
    return {static_cast<std::int32_t>(code), error.what(), std::move(field), std::string(why)};
}

Failure of(const StatusError& error) {
    const Status& status = error.status();
    return of(status.code, error, status.reason, status.violations.empty() ? "" : status.violations[0].field);
}

Failure translated() {
    try {
        throw;
    } catch (const StatusError& error) {
        return of(error);
    } catch (const InvalidArgument& error) {
        return of(StatusCode::invalid_argument, error, reason::field_invalid, error.field());
    } catch (const Cancelled& error) {
        return of(StatusCode::cancelled, error, reason::request_cancelled);
    } catch (const client::ConcurrencyError& error) {
        return of(StatusCode::failed_precondition, error, concurrent_use);
    } catch (const client::ConnectionError& error) {
        return of(StatusCode::unavailable, error, no_connection);
    } catch (const client::TimeoutError& error) {
        return of(StatusCode::deadline_exceeded, error, reason::deadline_passed);
    } catch (const std::bad_alloc&) {
        return {static_cast<std::int32_t>(StatusCode::resource_exhausted), "The memory is insufficient for this call.",
                "", std::string(reason::limit_exceeded)};
    } catch (const std::exception& error) {
        return of(StatusCode::internal, error, reason::unexpected);
    } catch (...) {
        return {static_cast<std::int32_t>(StatusCode::unknown), "A callback threw an exception.", "",
                std::string(reason::unexpected)};
    }
}

struct Kept {
    const void* handle = nullptr;
    Failure failure;
};
thread_local Kept last;

}  // namespace

Failure current_failure() noexcept {
    try {
        return translated();
    } catch (...) {  // without memory for the message
        return {static_cast<std::int32_t>(StatusCode::resource_exhausted), {}, {}, {}};
    }
}

void keep_failure(const void* handle, Failure failure) noexcept {
    last.handle = handle;
    last.failure = std::move(failure);
}

const Failure* kept_failure(const void* handle) noexcept {
    return handle == nullptr || handle == last.handle ? &last.failure : nullptr;
}

}  // namespace contactd::c

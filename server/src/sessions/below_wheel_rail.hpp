// Renames refused fields of a wheel-rail contact to those in messages of sessions.
#pragma once

#include "contactd/error.hpp"
#include "contactd/proto/session.hpp"

namespace contactd::server {

/// Returns the result of `ask` and renames refused fields to "wheelrail.setup.dx", "wheelrail.state.position.z", ...
template <class Ask>
auto below_wheel_rail(const Ask& ask) {
    try {
        return ask();
    } catch (const InvalidArgument& error) {
        throw proto::StatusError(proto::below_wheel_rail(status_of(error)));
    } catch (const proto::StatusError& error) {
        throw proto::StatusError(proto::below_wheel_rail(error.status()));
    }
}

}  // namespace contactd::server

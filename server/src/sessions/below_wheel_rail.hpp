// Refusals of a wheel-rail contact, as messages of sessions have its fields.
#pragma once

#include "contactd/error.hpp"
#include "contactd/proto/session.hpp"

namespace contactd::server {

/// Returns what `ask` does; its refusals name "wheelrail.setup.dx", "wheelrail.state.position.z", ...
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

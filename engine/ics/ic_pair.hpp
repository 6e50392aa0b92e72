// Requests the tables of two bodies, one after the other.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "ic_service.hpp"

namespace contactd::engine {

using IcAnswers = std::array<IcAnswer, 2>;  ///< upper body, lower body

/// Returns whether the upper body's table, `upper`, also serves the lower one. Dimensionless tables depend on nu only,
/// and families do not depend on the material.
bool serves_both(const IcAnswer& upper, const std::array<std::optional<IcSpec>, 2>& specs);

/// Holds callbacks of a request for a pair, called from any thread. `done` or `failed` is called exactly once;
/// exceptions of `done` go to `failed`.
struct IcPairCaller {
    std::function<void(const IcAnswers&)> done;
    std::function<void(const Status&)> failed;
    std::function<void(const Job&, const JobProgress&)> progress;
    QueueTicket ticket{};
};

/// Requests the existing tables of `specs`, the second only if it differs from the first.
void fetch_pair(IcService& ics, const std::array<std::optional<IcSpec>, 2>& specs, IcPairCaller caller);

}  // namespace contactd::engine

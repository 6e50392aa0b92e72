// The tables of two bodies, one request after the other.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "ic_service.hpp"

namespace contactd::engine {

using IcAnswers = std::array<IcAnswer, 2>;  ///< upper body, lower body

/// Whether the upper body's table, `upper`, serves the lower one, too: dimensionless tables know nothing of a material
/// but nu, and families not even that.
bool serves_both(const IcAnswer& upper, const std::array<std::optional<IcSpec>, 2>& specs);

/// Who asked for a pair. Called from any thread, `done` or `failed` exactly once; what `done` throws goes to `failed`.
struct IcPairCaller {
    std::function<void(const IcAnswers&)> done;
    std::function<void(const Status&)> failed;
    std::function<void(const Job&, const JobProgress&)> progress;
    QueueTicket ticket{};
};

/// Asks for the tables of `specs` that there are, for the second only when it is another one.
void fetch_pair(IcService& ics, const std::array<std::optional<IcSpec>, 2>& specs, IcPairCaller caller);

}  // namespace contactd::engine

// The tables of two bodies, one request after the other.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "ic_service.hpp"
#include "jobs/call.hpp"

namespace contactd::server {

using IcAnswers = std::array<IcAnswer, 2>;  ///< upper body, lower body

/// Asks for the tables of `specs` that there are, for the second only when it is another one. Progress goes to `call`;
/// then `done` or `failed` is called, from any thread; what `done` or the asking throws goes to `failed`.
void fetch_pair(const CallPtr& call, IcService& ics, const std::array<std::optional<IcSpec>, 2>& specs,
                std::function<void(const IcAnswers&)> done, std::function<void(const proto::Status&)> failed);

}  // namespace contactd::server

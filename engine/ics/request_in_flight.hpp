// A table being fetched and the callers waiting for it, shared by the parts of IcService.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ic_service.hpp"

namespace contactd::engine {

struct IcService::RequestInFlight {
    IcSpec spec;  // dimensionless
    std::string key;
    std::shared_ptr<Job> job;  // null until it is known that a build is needed
    std::vector<IcCaller> callers;
    std::string description{};  // of what the first caller asked for, with its lengths

    bool serves(const std::string& request, const IcSpec& other) const {
        return key == request && spec.nx >= other.nx && spec.ny >= other.ny && !(job && job->cancelled());
    }
};

}  // namespace contactd::engine

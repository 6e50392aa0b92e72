#include "job_reports.hpp"

#include <cmath>
#include <cstdint>
#include <format>
#include <utility>
#include <vector>

namespace contactd::server {

nlohmann::json to_json(const Job& job, const JobProgress& progress) {
    nlohmann::json json = {{"job", job.name},
                           {"stage", progress.stage},
                           {"fraction", progress.fraction},
                           {"iteration", progress.iteration},
                           {"residual", std::isfinite(progress.residual) ? progress.residual : 0.0}};
    if (progress.seconds_left) json["seconds_left"] = *progress.seconds_left;
    if (progress.memory_bytes) json["memory_bytes"] = *progress.memory_bytes;
    return json;
}

engine::JobOrigin origin_of(const Call& call, const std::string& kind) {
    const nlohmann::json& params = call.request.params;
    std::string description = call.request.method;
    // The parameters have not passed their schema yet.
    const auto count = [](const nlohmann::json& from, const char* name) {
        const auto at = from.is_object() ? from.find(name) : from.end();
        return at != from.end() && at->is_number_unsigned() ? at->get<std::uint64_t>() : 0;
    };
    if (params.is_object()) {
        if (const auto grid = params.find("grid"); grid != params.end())
            if (const auto nx = count(*grid, "nx"), ny = count(*grid, "ny"); nx > 0 && ny > 0)
                description += std::format(", {} x {} elements", nx, ny);
        for (const char* name : {"problems", "steps"})
            if (const auto list = params.find(name); list != params.end() && list->is_array())
                description += std::format(", {} {}", list->size(), name);
    }
    return {kind, std::move(description), [user = call.user()] { return std::vector{user}; }};
}

}  // namespace contactd::server

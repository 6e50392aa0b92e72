#include "job_reports.hpp"

#include <cmath>

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

}  // namespace contactd::server

#include "job.hpp"

#include <cmath>

namespace contactd::server {

nlohmann::json to_json(const Job& job, const JobProgress& progress) {
    return {{"job", job.name},
            {"stage", progress.stage},
            {"fraction", progress.fraction},
            {"iteration", progress.iteration},
            {"residual", std::isfinite(progress.residual) ? progress.residual : 0.0}};
}

}  // namespace contactd::server

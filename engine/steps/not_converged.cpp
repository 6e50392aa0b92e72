#include "engine/steps/not_converged.hpp"

#include <format>

namespace contactd::engine {

void MissedTolerances::add(const char* name, const std::optional<SolverEvidence>& solver) {
    if (!solver || solver->converged) return;
    solvers_ += std::format("{}{} after {} iterations at the residual {}", solvers_.empty() ? "" : ", ", name,
                            solver->iterations, solver->residual);
}

void MissedTolerances::add(const ContactEvidence& evidence) {
    add("normal", evidence.normal);
    add("tangential", evidence.tangential);
    add("outer", evidence.outer);
    add("force", evidence.force);
}

StatusError MissedTolerances::error() const {
    return {StatusCode::aborted, reason::not_converged,
            "The step did not converge (" + solvers_ +
                "), and the session keeps its previous state. Use a smaller step, or open the session with other "
                "settings or with accept_unconverged."};
}

}  // namespace contactd::engine

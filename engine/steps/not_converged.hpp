// Explains why an unconverged step is rejected.
#pragma once

#include <optional>
#include <string>

#include "contactd/contact.hpp"
#include "contactd/status.hpp"

namespace contactd::engine {

/// Lists the solvers that missed their tolerance.
class MissedTolerances {
   public:
    void add(const char* name, const std::optional<SolverEvidence>& solver);
    void add(const ContactEvidence& evidence);
    /// ABORTED, NOT_CONVERGED.
    StatusError error() const;

   private:
    std::string solvers_;
};

}  // namespace contactd::engine

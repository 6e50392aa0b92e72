// One table on one mesh for one Poisson's ratio.
#pragma once

#include "collective_observer.hpp"
#include "contactd/ic_store.hpp"
#include "linear_system.hpp"

namespace contactd::fem {

/// A stretch of a build's progress.
struct ProgressPart {
    CollectiveObserver* observer;
    double first = 0, share = 1;

    void report(const char* stage, double fraction, int iteration = 0, double residual = 0) const {
        observer->report({stage, first + share * fraction, iteration, residual});
    }
    ProgressPart part(double from, double length) const { return {observer, first + share * from, share * length}; }
};

/// What a load prescribes.
using CaseOf = std::function<LoadCase(ElasticityProblem& problem, Axis load)>;

/// Displacements under one load, in true degrees of freedom.
struct Solution {
    Axis load;
    mfem::Vector displacements;
};

/// Collective. Assembles the system of `problem` and solves `case_of` each load; of the evidence it fills the load
/// cases and their times. Throws NotConverged when a load case misses its tolerance.
std::vector<Solution> solve_loads(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress,
                                  IcEvidence& evidence);

/// Collective. The same, and reads the table off; the evidence lacks errors, warnings and the total time.
IcRecord solve_and_sample(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress);

/// Collective. Sets the total time since `start`, and all times to those of the slowest process, so that every process
/// returns the same record.
void finish_evidence(IcEvidence& evidence, double start, MPI_Comm comm);

/// Collective. `spec` is dimensionless, its mesh given (accuracy 0), and no family. The record carries its evidence,
/// with errors where there is a closed form. Throws NotConverged when a load case misses its tolerance.
IcRecord build_on_mesh(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// The same on the mesh of `problem`; the total time counts from `start`.
IcRecord build_on_problem(ElasticityProblem& problem, const ProgressPart& progress, double start);

}  // namespace contactd::fem

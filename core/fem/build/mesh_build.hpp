// Builds one table on one mesh for one Poisson's ratio.
#pragma once

#include "collective_observer.hpp"
#include "contactd/ic_store.hpp"
#include "system/linear_system.hpp"

namespace contactd::fem {

/// Holds times of a stretch (s): elapsed, expected for the next step, and expected for the rest of the stretch if it
/// can be estimated.
struct StepTimes {
    double before, step;
    std::optional<double> left;
};

/// A stretch of a build's progress.
struct ProgressPart {
    CollectiveObserver* observer;
    double first = 0, share = 1;

    /// `step`: expected time (s) until the next report.
    void report(const char* stage, double fraction, int iteration = 0, double residual = 0, double step = 0) const {
        const double now = first + share * fraction;
        observer->report({stage, now, iteration, residual, step, now});
    }
    /// Reports a step that lasts until `fraction` reaches `until`, without progress of its own.
    void begin(const char* stage, double fraction, double until, const StepTimes& times) const {
        std::optional<double> left = times.left;
        if (left && share > 0) *left += (1 - first - share) / share * (times.before + *left);
        observer->report({stage, first + share * fraction, 0, 0, times.step, first + share * until, left});
    }
    ProgressPart part(double from, double length) const { return {observer, first + share * from, share * length}; }
};

/// Creates the values that a load prescribes.
using CaseOf = std::function<LoadCase(ElasticityProblem& problem, Axis load)>;

/// Throws NotConverged with the load and the reached tolerance if the solve did not converge.
void require_converged(const SolveResult& result, Axis load, const FemSpec& fem);

/// Returns the displacements under one load, in true degrees of freedom.
struct Solution {
    Axis load;
    mfem::Vector displacements;
};

/// Collective. Assembles the system of `problem` and solves `case_of` each load. Sets the load cases and their times in
/// the evidence. Throws NotConverged if a load case misses its tolerance.
std::vector<Solution> solve_loads(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress,
                                  IcEvidence& evidence);

/// Collective. Does the same and reads the table from the solution. The evidence lacks errors, warnings and the total
/// time.
IcRecord solve_and_sample(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress);

/// Returns warnings for users of a table on a given mesh: choices that the paper advises against, and errors above 1 %.
std::vector<std::string> table_warnings(const IcSpec& spec, const IcEvidence& evidence);

/// Collective. Sets the total time since `start`, and all times to those of the slowest process, so that all processes
/// return the same record.
void finish_evidence(IcEvidence& evidence, double start, MPI_Comm comm);

/// Collective. `spec` is dimensionless, with a given mesh (accuracy 0), and no family. The record contains its
/// evidence, with errors if a closed form exists. Throws NotConverged if a load case misses its tolerance.
IcRecord build_on_mesh(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress);

/// Builds on the mesh of `problem`; the total time counts from `start`.
IcRecord build_on_problem(ElasticityProblem& problem, const ProgressPart& progress, double start);

}  // namespace contactd::fem

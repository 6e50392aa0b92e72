// Runs the cases of an input file in their order. A file is a history: a step starts from the end of the previous one.
// An error in a case therefore affects its successors, but not other histories.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "answers/solved.hpp"
#include "contactd/contact_file_run.hpp"
#include "contactd/observer.hpp"
#include "contactd/read_contact_file.hpp"
#include "given/given_rail.hpp"
#include "given/named_files.hpp"
#include "run/rail_history.hpp"

namespace contactd::cases {

/// Solves the problems of cases.
class ProblemSolver {
   public:
    virtual ~ProblemSolver() = default;
    virtual SolveReply solve(const ContactProblem& problem) = 0;
    virtual WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state,
                                    WheelRailEstimates& estimates) = 0;
};

/// Returns the largest number of points of all blocks below the contacts of a case.
constexpr std::size_t most_block_points(std::size_t max_elements) {
    return std::min<std::size_t>(10 * max_elements, 1'000'000);
}

class CaseRun {
   public:
    /// Throws InvalidArgument as ContactFileReader does.
    explicit CaseRun(ContactFileInput input);

    /// Sets ContactFileInput::max_elements for the cases that follow.
    void limit(std::size_t max_elements) { input_.max_elements = max_elements; }

    /// Reads and solves the next requested case; none at the end. Errors of a case are its outcome. Throws Cancelled.
    std::optional<ContactFileOutcome> next(ProblemSolver& solver, const Observer& observer);
    /// Reads the next requested case without solving it, except for a normal force on which it depends.
    std::optional<ContactFileProblem> convert_next(ProblemSolver& solver, const Observer& observer);

    /// Sentences about the file so far that do not concern a case.
    const std::vector<std::string>& warnings() const { return reader_.warnings(); }
    const std::vector<std::string>& errors() const { return reader_.errors(); }

    std::size_t bytes() const;  ///< memory of the text, the files and the ends of steps, about

   private:
    /// The cases that may continue each other have the same module, result element and contact problem.
    using Key = std::tuple<int, std::optional<int>, std::optional<int>>;
    struct History {
        std::optional<Solved> solved{};  ///< the last case of module 3
        RailHistory rail{};
        /// Contains rows of the patches of the last step and of the one before, along the surface of the rail (mm).
        std::vector<Extent> rows{}, rows_before{};
        bool has_rows = false;
        std::string broken{};  ///< the reason why the cases that follow cannot continue; empty if they can
    };
    /// Lets the reader ask the current observer whether the run is cancelled.
    struct Asked : Observer {
        const Observer* now = nullptr;
        bool cancelled() const override { return now != nullptr && now->cancelled(); }
    };

    std::optional<ContactCase> read_next();
    void refuse_early(const ContactCase& read, const History& history, ContactFileOutcome& outcome) const;
    void solve(const ContactCase& read, History& history, ProblemSolver& solver, ContactFileOutcome& outcome);
    void solve_basic(const ContactCase& read, History& history, ProblemSolver& solver, ContactFileOutcome& outcome);
    void solve_on_rails(const ContactCase& read, History& history, ProblemSolver& solver, ContactFileOutcome& outcome);
    ContactProblem basic_problem(const ContactCase& read, Given& given, const Solved* last,
                                 ProblemSolver& solver) const;
    WheelRailProblem rail_problem(const ContactCase& read, Given& given) const;

    ContactFileInput input_;
    GivenFiles files_;
    Asked asked_;
    ContactFileReader reader_;
    std::size_t at_ = 0, wanted_ = 0;  ///< number of cases read, and of requested ones
    std::map<Key, History> histories_;
    std::size_t file_bytes_ = 0;
};

}  // namespace contactd::cases

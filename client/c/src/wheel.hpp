// Represents a wheel on its rail: its inputs, and the results of its last solve.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cancellable_handle.hpp"
#include "saved_states.hpp"

namespace contactd::c {

/// Use it in one thread at a time (HandleGuard), except cancel and the failures.
class Wheel : public CancellableHandle {
   public:
    explicit Wheel(const Connection& connection);

    WheelInput inputs;  ///< written by functions that set fields
    std::optional<std::chrono::milliseconds> timeout;

    /// Continues from the last solve, or repeats it from its initial state.
    enum class Which { next, again };
    void solve(Which which = Which::next);
    /// Solves wheels, which this thread uses, like Backend::solve_many. Returns the exception of each, or null.
    static std::vector<std::exception_ptr> solve_many(std::span<Wheel* const> wheels, int threads);
    std::int32_t save();
    void restore(std::int32_t state);
    void forget(std::int32_t state);
    /// Solves both wheels of a wheelset, which this thread uses. Throws InvalidArgument for inconsistent
    /// inputs.
    static void solve_wheelset(Wheel& right, Wheel& left);

    /// Returns the solution of the last solve. Throws StatusError (NO_RESULT) if there is none.
    const WheelRailSolution& solution() const;
    /// Returns the roll of the wheelset, prescribed or computed (rad).
    double roll() const { return result().roll; }
    /// Evidence of a computed roll.
    const std::optional<SolverEvidence>& roll_search() const { return result().roll_search; }
    bool converged() const { return solution().converged() && (!roll_search() || roll_search()->converged); }
    /// Throws StatusError (NO_RESULT) if the array was not requested in the last solve.
    void require(SolutionField field) const;
    void require_gap() const;

   private:
    struct Result {
        WheelRailSolution solution;
        SolutionFields fields;
        bool gap = false;
        double roll = 0;
        std::optional<SolverEvidence> roll_search{};
    };
    const Result& result() const;
    /// Returns its own timeout, or that of builds if it may wait for finite-element tables.
    std::optional<std::chrono::milliseconds> effective_timeout() const {
        const bool may_build = inputs.setup.conformal == Conformal::fem;
        return !timeout && may_build ? std::optional(settings_.build_timeout) : timeout;
    }
    struct Saved {
        std::string name;  // of the open wheel
        std::shared_ptr<const Result> result;
    };
    /// Stores the result as the last one, and reports its warnings.
    void take(Result result);
    /// Returns the result of a solve of the inputs.
    void take(WheelRailSolution solution);
    /// Ensures that a wheel is open, and removes the data of another set-up. Throws InvalidArgument ("setup") for a
    /// transient step that cannot continue.
    OpenWheel& open_for(const WheelRailSetup& setup, bool transient);
    OpenWheel& open_for_inputs() {
        return open_for(inputs.setup, inputs.state.motion != WheelRailMotion::steady_rolling);
    }

    std::unique_ptr<OpenWheel> open_;
    bool moved_ = false;  // true after a solve, from which the next one continues
    std::shared_ptr<const Result> result_;
    SavedStates<Saved> saved_;
};

}  // namespace contactd::c

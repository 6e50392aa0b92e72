// A wheel on its rail: its inputs, and the results of its last solve.
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

/// One thread at a time (HandleGuard), but for cancel and the failures.
class Wheel : public CancellableHandle {
   public:
    explicit Wheel(const Connection& connection);

    WheelInput inputs;  ///< functions that set fields write here
    std::optional<std::chrono::milliseconds> timeout;

    /// Goes on from the last solve, or from where that started.
    enum class Which { next, again };
    void solve(Which which = Which::next);
    /// Solves wheels, each of which this thread uses, as Backend::solve_many does. Returns what each threw, or null.
    static std::vector<std::exception_ptr> solve_many(std::span<Wheel* const> wheels, int threads);
    std::int32_t save();
    void restore(std::int32_t state);
    void forget(std::int32_t state);
    /// Solves both wheels of a wheelset, each of which this thread uses. Throws InvalidArgument where their inputs do
    /// not go together.
    static void solve_wheelset(Wheel& right, Wheel& left);

    /// Returns the solution of the last solve. Throws StatusError (NO_RESULT) when there is none.
    const WheelRailSolution& solution() const;
    /// Returns the roll of the wheelset, as prescribed or found (rad).
    double roll() const { return result().roll; }
    /// Where the roll was found.
    const std::optional<SolverEvidence>& roll_search() const { return result().roll_search; }
    bool converged() const { return solution().converged() && (!roll_search() || roll_search()->converged); }
    /// Throws StatusError (NO_RESULT) when the last solve was not asked for the array.
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
    /// Its own timeout, or that of builds where it may have to wait for tables by finite elements.
    std::optional<std::chrono::milliseconds> effective_timeout() const {
        const bool may_build = inputs.setup.conformal == Conformal::fem;
        return !timeout && may_build ? std::optional(settings_.build_timeout) : timeout;
    }
    struct Saved {
        std::string name;  // of the open wheel
        std::shared_ptr<const Result> result;
    };
    /// Keeps the result as the last one, and reports its warnings.
    void take(Result result);
    /// That of a solve of the inputs.
    void take(WheelRailSolution solution);
    /// Makes sure that a wheel is open, and forgets what belongs to another set-up. Throws InvalidArgument ("setup")
    /// for a transient step that could not go on.
    OpenWheel& open_for(const WheelRailSetup& setup, bool transient);
    OpenWheel& open_for_inputs() {
        return open_for(inputs.setup, inputs.state.motion != WheelRailMotion::steady_rolling);
    }

    std::unique_ptr<OpenWheel> open_;
    bool moved_ = false;  // there was a solve, from which the next one goes on
    std::shared_ptr<const Result> result_;
    SavedStates<Saved> saved_;
};

}  // namespace contactd::c

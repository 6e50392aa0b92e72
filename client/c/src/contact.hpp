// Represents a contact: its inputs, its solver, and the results of its last step.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cancellable_handle.hpp"
#include "inputs.hpp"
#include "saved_states.hpp"

namespace contactd::c {

/// Holds the answer of a step, and the arrays that were requested with it.
struct Result {
    StepReply reply;
    std::vector<SolutionField> fields;
};

/// Use it in one thread at a time (HandleGuard), except cancel and the failures.
class Contact : public CancellableHandle {
   public:
    explicit Contact(const Connection& connection);

    ContactInputs inputs;  ///< written by functions that set fields

    bool started() const { return open_ != nullptr; }
    /// Throws StatusError (WRONG_ORDER) if the contact was started.
    void require_set_up(const char* what) const;
    /// Throws StatusError (WRONG_ORDER) if the contact was not started.
    void require_started() const;

    void start();
    /// Solves the next step, or repeats the last one requested.
    enum class Which { next, again };
    void step(Which which = Which::next);
    void close();
    std::int32_t save();
    void restore(std::int32_t state);
    void forget(std::int32_t state);

    /// Returns the result of the last step. Throws StatusError (NO_RESULT) if there is none.
    const Result& result() const;
    /// Throws StatusError (NO_RESULT) if the array was not requested in the last step.
    void require(SolutionField field) const;
    const IcUses& ics() const;
    /// Returns the frames of the columns of a section, which are the rows of the grid.
    std::vector<StripFrame> frames(const Section& section);
    /// Returns the number of the last step, 0 before the first.
    std::int32_t step_number() const;

   private:
    struct Saved {
        std::string name;  // in the session
        std::shared_ptr<const Result> result;
        Motion motion;  // with the initial estimates of the next step
    };

    std::unique_ptr<OpenContact> open_;
    std::shared_ptr<const Result> result_;
    SavedStates<Saved> saved_;
};

}  // namespace contactd::c

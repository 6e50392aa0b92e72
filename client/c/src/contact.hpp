// A contact: its inputs, the place where it is solved, and the results of its last step.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cancellable_handle.hpp"
#include "inputs.hpp"
#include "saved_states.hpp"

namespace contactd::c {

/// The answer of a step, and the arrays that were requested with it.
struct Result {
    StepReply reply;
    std::vector<SolutionField> fields;
};

/// One thread at a time (HandleGuard), but for cancel and the failures.
class Contact : public CancellableHandle {
   public:
    explicit Contact(const Connection& connection);

    ContactInputs inputs;  ///< functions that set fields write here

    bool started() const { return open_ != nullptr; }
    /// Throws StatusError (WRONG_ORDER) when the contact was started.
    void require_set_up(const char* what) const;
    /// Throws StatusError (WRONG_ORDER) when the contact was not started.
    void require_started() const;

    void start();
    /// The next step, or the one that was asked for last.
    enum class Which { next, again };
    void step(Which which = Which::next);
    void close();
    std::int32_t save();
    void restore(std::int32_t state);
    void forget(std::int32_t state);

    /// Returns the result of the last step. Throws StatusError (NO_RESULT) when there is none.
    const Result& result() const;
    /// Throws StatusError (NO_RESULT) when the last step was not asked for the array.
    void require(SolutionField field) const;
    const IcUses& ics() const;
    /// Where the columns of a section lie that are the rows of the grid.
    std::vector<StripFrame> frames(const Section& section);
    /// Returns the number of the last step, 0 before the first.
    std::int32_t step_number() const;

   private:
    struct Saved {
        std::string name;  // in the session
        std::shared_ptr<const Result> result;
        Motion motion;  // with the estimates that the next step would have started from
    };

    std::unique_ptr<OpenContact> open_;
    std::shared_ptr<const Result> result_;
    SavedStates<Saved> saved_;
};

}  // namespace contactd::c

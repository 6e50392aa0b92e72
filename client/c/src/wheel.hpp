// A wheel on its rail: what was said of it, and the results of its last solve.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "called.hpp"

namespace contactd::c {

/// One thread at a time (Turn), but for cancel and the failures.
class Wheel : public Called {
   public:
    explicit Wheel(const Connection& connection) : Called(connection) {}

    WheelInput said;  ///< the setters write here
    std::optional<std::chrono::milliseconds> timeout;

    void solve();

    /// Of the last solve. Throws StatusError (NO_RESULT) when there is none.
    const WheelRailSolution& solution() const;
    /// One of its patches, from 0. Throws InvalidArgument ("patch") when there is none of this number.
    const WheelRailPatch& patch(std::int32_t number) const;
    /// Throws StatusError (NO_RESULT) when the last solve was not asked for the array.
    void require(SolutionField field) const;
    void require_gap() const;

   private:
    struct Result {
        WheelRailSolution solution;
        SolutionFields fields;
        bool gap = false;
    };
    const Result& result() const;

    std::unique_ptr<OpenWheel> open_;
    std::optional<Result> result_;
};

}  // namespace contactd::c

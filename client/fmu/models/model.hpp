// Declares the model of an instance: a plain contact, or a wheel on its rail. Both only use contactd.h.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "failure.hpp"
#include "variables/generated/history.hpp"
#include "variables/values.hpp"

namespace contactd::fmu {

/// Reports warnings of a step and the progress of builds, in the thread of the call.
using Tell = std::function<void(Status status, const std::string& sentence)>;

/// The result of a step other than the values: the numbers of its inputs, and for a contact the arrays that the next
/// step continues from. Empty before the first step.
struct Carried {
    std::vector<double> solved{};
    std::array<std::vector<double>, history_arrays.size()> history{};
};

/// Holds available derivatives of a model: rows are outputs, columns inputs, by their value references.
struct DerivativePlaces {
    std::vector<std::size_t> of, by;
};

/// Use it in one thread at a time, except cancel. All functions may throw Failure; a failure leaves the model
/// unchanged.
class Model {
   public:
    virtual ~Model() = default;
    /// Opens it with the parameters, to continue from `from`, which may be empty. An open model returns to that state;
    /// its parameters are those of its opening.
    virtual void start(const Values& values, const Carried& from) = 0;
    /// Solves the state before the first step with the inputs in `values`, and writes the outputs there. Called once,
    /// after the start. A solution that did not converge is reported, but is not a failure.
    virtual void solve_start(Values& values) = 0;
    /// Solves a step of `size` seconds with the inputs in `values`, and writes the outputs there.
    virtual void step(Values& values, double size) = 0;
    /// Returns the state after the last step; the first call solves that step again.
    virtual Carried carried() = 0;
    virtual const DerivativePlaces& derivative_places() const = 0;
    /// Returns those of the last step, row by row of `derivative_places`; NaN if unavailable. May solve that step
    /// again.
    virtual std::vector<double> derivatives() = 0;
    /// Ends the running step, from any thread.
    virtual void cancel() = 0;
};

}  // namespace contactd::fmu

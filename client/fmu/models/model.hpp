// An instance solves one of these: a plain contact, or a wheel on its rail. Both by contactd.h alone.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "failure.hpp"
#include "variables/values.hpp"

namespace contactd::fmu {

/// Tells what happens, in the thread of the call: warnings of a step, how far a build is.
using Tell = std::function<void(Status status, const std::string& sentence)>;

/// A step leaves these behind, beside the values: the numbers that it was solved with; and of a contact the tractions
/// of each element, in the order of contactd.h, and what its particles carry beside these. Empty before the first step.
struct Carried {
    std::vector<double> solved{}, pressure{}, traction_x{}, traction_y{}, yield_stress{}, friction_coefficient{};
};

/// Which derivatives a model has: rows are outputs, columns inputs, by their value references.
struct DerivativePlaces {
    std::vector<std::size_t> of, by;
};

/// For one thread at a time, but for cancel. All may throw Failure; what fails leaves the model as it was.
class Model {
   public:
    virtual ~Model() = default;
    /// Opens it with the parameters, to go on from where `from` was left, which may be empty. A model that is open goes
    /// there; its parameters are those that it was opened with.
    virtual void start(const Values& values, const Carried& from) = 0;
    /// Solves the state before the first step with the inputs of `values`, into which its outputs come. Called once,
    /// after the start; a solution that did not converge is reported, and is no failure.
    virtual void solve_start(Values& values) = 0;
    /// A step of `size` seconds with the inputs of `values`; its outputs come into these.
    virtual void step(Values& values, double size) = 0;
    /// Returns what the steps made so far leave behind; asked for the first time it solves the last step once more.
    virtual Carried carried() = 0;
    virtual const DerivativePlaces& derivative_places() const = 0;
    /// Returns those of the last step, row by row of `derivative_places`; NaN where there is none. May solve that step
    /// once more.
    virtual std::vector<double> derivatives() = 0;
    /// From any thread: a step that runs ends.
    virtual void cancel() = 0;
};

}  // namespace contactd::fmu

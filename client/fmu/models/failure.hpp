// Failures of an instance, in the terms of neither version of FMI.
#pragma once

#include <stdexcept>
#include <string>

namespace contactd::fmu {

/// discard: the step was not made, and the instance stays where it was; a smaller one, or another input, may do.
enum class Status { ok, warning, discard, error };

/// what() is a sentence, or more.
struct Failure : std::runtime_error {
    Failure(Status how, const std::string& sentence) : std::runtime_error(sentence), status(how) {}
    explicit Failure(const std::string& sentence) : Failure(Status::error, sentence) {}

    Status status;
};

}  // namespace contactd::fmu

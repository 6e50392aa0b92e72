// Describes failures of an instance, independent of the version of FMI.
#pragma once

#include <stdexcept>
#include <string>

namespace contactd::fmu {

/// discard: the step failed, and the instance is unchanged; a smaller step or another input may succeed.
enum class Status { ok, warning, discard, error };

/// what() is one or more sentences.
struct Failure : std::runtime_error {
    Failure(Status how, const std::string& sentence) : std::runtime_error(sentence), status(how) {}
    explicit Failure(const std::string& sentence) : Failure(Status::error, sentence) {}

    Status status;
};

}  // namespace contactd::fmu

// Defines the exceptions of contactd. They share one base, so that a caller can catch everything the project throws
// with one handler. The edge of a process (server, contactd-ic) converts them to status codes.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace contactd {

/// This is the base of every exception thrown deliberately. `what()` is a whole sentence.
class Error : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
};

/// An argument is invalid. `field()` is its path on the wire, e.g. "grid.nx" or "upper.nu". `problem()` states the
/// value and the allowed values, e.g. "is -1; it must be positive". what() contains both.
class InvalidArgument : public Error {
   public:
    InvalidArgument(std::string field, std::string problem)
        : Error(field + " " + problem), field_(std::move(field)), problem_(std::move(problem)) {}
    const std::string& field() const noexcept { return field_; }
    const std::string& problem() const noexcept { return problem_; }

   private:
    std::string field_, problem_;
};

/// The work was cancelled by its observer.
class Cancelled : public Error {
   public:
    Cancelled() : Error("The computation was cancelled.") {}
    using Error::Error;
};

/// A finite-element or contact solve did not reach its tolerance, and an unconverged result cannot be used.
class NotConverged : public Error {
   public:
    using Error::Error;
};

/// A computation requires more memory than allowed. `field()` names the argument that causes it, as in
/// InvalidArgument.
class OutOfMemory : public Error {
   public:
    OutOfMemory(std::string field, const std::string& sentence) : Error(sentence), field_(std::move(field)) {}
    const std::string& field() const noexcept { return field_; }

   private:
    std::string field_;
};

/// The IC store or one of its files cannot be read or written.
class StoreError : public Error {
   public:
    using Error::Error;
};

}  // namespace contactd

// The exceptions of contactd. One base, so that a caller can catch everything the project throws with one handler;
// the edge of a process (server, contactd-ic) turns them into status codes.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace contactd {

/// Base of every exception thrown on purpose. `what()` is a whole sentence.
class Error : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
};

/// An argument that cannot be used. `field()` is its path in the words of the wire, e.g. "grid.nx" or "upper.nu";
/// `problem()` says what the value is and what would be right, e.g. "is -1; it must be positive". what() is both.
class InvalidArgument : public Error {
   public:
    InvalidArgument(std::string field, std::string problem)
        : Error(field + " " + problem), field_(std::move(field)), problem_(std::move(problem)) {}
    const std::string& field() const noexcept { return field_; }
    const std::string& problem() const noexcept { return problem_; }

   private:
    std::string field_, problem_;
};

/// The work was ended because its observer asked for it.
class Cancelled : public Error {
   public:
    Cancelled() : Error("The computation was cancelled.") {}
    using Error::Error;
};

/// A finite-element or contact solve that did not reach its tolerance where an unconverged answer is of no use.
class NotConverged : public Error {
   public:
    using Error::Error;
};

/// A computation that needs more memory than it may use. `field()` is what asks for it, as of an InvalidArgument.
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

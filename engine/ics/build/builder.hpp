// Runs one build: contactd-ic as a child process, started by the configured launcher.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/ic_spec.hpp"
#include "engine/jobs/job.hpp"

namespace contactd::engine {

struct BuilderCommand {
    std::vector<std::string> launcher;                     ///< e.g. {"mpirun", "-np", "4"}; empty: none
    std::filesystem::path program;                         ///< contactd-ic
    std::vector<std::string> environment{"PATH", "HOME"};  ///< variables that are passed on (passed_on)
    std::size_t max_memory_bytes = 0;                      ///< for all processes on one machine; 0: the builder decides
    std::chrono::seconds stall{0};                         ///< longest time without progress; 0: no limit
    std::chrono::seconds longest{0};                       ///< duration of a build; 0: no limit
};

/// Holds the table that a builder printed because it could not write the output file; otherwise empty.
struct BuiltTable {
    std::vector<unsigned char> bytes;  ///< of the IC file
    std::string problem;               ///< why, as a sentence
};

/// The builder could not be started or communicated with, which is not a failure of the table.
class BuilderUnusable : public Error {
   public:
    using Error::Error;
};

/// Reports that the builder ran out of memory, or would have. `field()` is the field of the request that demands too
/// much, or empty if it is unknown.
class BuilderOutOfMemory : public Error {
   public:
    BuilderOutOfMemory(const std::string& sentence, std::string field) : Error(sentence), field_(std::move(field)) {}
    const std::string& field() const noexcept { return field_; }

   private:
    std::string field_;
};

/// Writes the table of `spec` to `output` and returns when the child has ended. The child ends with this process,
/// because it watches its standard input. `on_tick` is called several times a second. Throws Cancelled if the job was
/// cancelled, InvalidArgument if the builder refuses the spec, BuilderOutOfMemory, BuilderUnusable, and Error with the
/// builder's message, or if it was silent or running for too long. The child has ended in any case.
BuiltTable run_builder(const BuilderCommand& command, const IcSpec& spec, const std::filesystem::path& output,
                       const Job& job, const std::function<void(const JobProgress&)>& on_progress,
                       const std::function<void()>& on_tick);

}  // namespace contactd::engine

// One build: contactd-ic as a child process, behind the configured launcher.
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
    std::size_t max_memory_bytes = 0;                      ///< of all processes on one machine; 0: the builder decides
    std::chrono::seconds stall{0};                         ///< longest time without progress; 0: no limit
    std::chrono::seconds longest{0};                       ///< duration of a build; 0: no limit
};

/// A table that a builder hands over by itself because it could not be written where it belongs; empty otherwise.
struct BuiltTable {
    std::vector<unsigned char> bytes;  ///< of the IC file
    std::string problem;               ///< why, as a sentence
};

/// The builder could not be started or talked to: that says nothing about the table.
class BuilderUnusable : public Error {
   public:
    using Error::Error;
};

/// The builder ran out of memory, or would have. `field()` is the part of the request that asks for too much, empty
/// when that was not known before.
class BuilderOutOfMemory : public Error {
   public:
    BuilderOutOfMemory(const std::string& sentence, std::string field) : Error(sentence), field_(std::move(field)) {}
    const std::string& field() const noexcept { return field_; }

   private:
    std::string field_;
};

/// Writes the table of `spec` to `output` and returns when the child has ended. The child lives no longer than this
/// process: it watches its standard input. `on_tick` is called some times a second meanwhile. Throws Cancelled when the
/// job was cancelled, InvalidArgument when the builder refuses the spec, BuilderOutOfMemory, BuilderUnusable, and Error
/// with the builder's own words, or when it was silent or at work for too long; the child has then been ended.
BuiltTable run_builder(const BuilderCommand& command, const IcSpec& spec, const std::filesystem::path& output,
                       const Job& job, const std::function<void(const JobProgress&)>& on_progress,
                       const std::function<void()>& on_tick);

}  // namespace contactd::engine

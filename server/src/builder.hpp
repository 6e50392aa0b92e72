// One build: contactd-ic as a child process, behind the configured launcher.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "job.hpp"

namespace contactd::server {

struct BuilderCommand {
    std::vector<std::string> launcher;                     ///< e.g. {"mpirun", "-np", "4"}; empty: none
    std::filesystem::path program;                         ///< contactd-ic
    std::vector<std::string> environment{"PATH", "HOME"};  ///< variables that are passed on (passed_on)
};

/// Writes the table of `spec` to `output` and returns when the child has ended. The child lives no longer than this
/// process: it watches its standard input. Throws Cancelled when the job was cancelled (the child is ended first) and
/// Error with the builder's own words when it failed.
void run_builder(const BuilderCommand& command, const IcSpec& spec, const std::filesystem::path& output, Job& job,
                 const std::function<void(const JobProgress&)>& on_progress);

}  // namespace contactd::server

// Tests runs that wait for their next call.
#include "contact_files/file_runs.hpp"

#include <catch2/catch_test_macros.hpp>

#include "contactd/proto/status.hpp"

using namespace contactd;
using namespace contactd::server;

namespace {

FileRuns::RunPtr new_run() {
    ContactFileInput input;
    input.text = "0 MODULE\n";
    return std::make_unique<cases::CaseRun>(std::move(input));
}

bool is_unknown(FileRuns& runs, const std::string& name) {
    try {
        runs.take(name);
    } catch (const proto::StatusError& error) {
        CHECK(error.status().reason == "RUN_UNKNOWN");
        return true;
    }
    return false;
}

}  // namespace

TEST_CASE("a run belongs to one call at a time, and keeps its name", "[contact_files]") {
    FileRuns runs;
    const std::string name = runs.keep(new_run());
    FileRuns::RunPtr run = runs.take(name);
    CHECK(run != nullptr);
    CHECK(is_unknown(runs, name));
    CHECK(runs.keep(std::move(run), name) == name);
    CHECK_FALSE(is_unknown(runs, name));
}

TEST_CASE("only the last runs are kept", "[contact_files]") {
    FileRuns runs;
    const std::string first = runs.keep(new_run()), second = runs.keep(new_run());
    for (int i = 0; i < 255; ++i) runs.keep(new_run());
    CHECK(is_unknown(runs, first));
    CHECK_FALSE(is_unknown(runs, second));
    CHECK(is_unknown(runs, "no such run"));
}

// Tests the IC service with a shell script as builder, which plays all roles of a real one.
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "contactd/half_space.hpp"
#include "contactd/ic_family.hpp"
#include "engine/ics/ic_service.hpp"

using namespace contactd;
using namespace contactd::engine;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
namespace fs = std::filesystem;

namespace {

IcSpec fem_spec(int nx = 3, int ny = 3) {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = nx;
    spec.ny = ny;
    spec.source = IcSource::fem;
    return spec;
}

/// Creates a family over Poisson's ratio in the builder's format, of closed-form tables, which are linear in it.
IcRecord family_record() {
    IcSpec spec = fem_spec();
    spec.any_nu = true;
    IcRecord record{dimensionless(spec)};
    IcFamily family;
    record.evidence.family_nu = family_points(3);
    for (const double nu : record.evidence.family_nu) {
        IcSpec one = record.spec;
        one.source = IcSource::analytic;
        one.any_nu = false;
        one.material.nu = nu;
        family.tables.push_back(half_space_table(one));
    }
    record.tables = std::move(family);
    return record;
}

struct Outcome {
    std::string origin;
    proto::Status status;
    IcAnswer answer;
};

/// Creates a service in its own folder, whose builder is `script` (run by sh; $3 is the output).
class Bench {
   public:
    explicit Bench(const std::string& script, std::function<bool(const std::string&)> may_build = {}) {
        std::string name = (fs::temp_directory_path() / "contactd-ics-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        folder = name;
        const fs::path program = folder / "builder";
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(program, fs::perms::owner_all);
        IcService::Settings settings{{{}, program}, 1, 1 << 20};
        settings.may_build = std::move(may_build);
        ics = std::make_unique<IcService>(std::move(settings), IcStore(folder / "store", [](const std::string&) {}),
                                          jobs, counters);
        // Creates a table for scripts that succeed.
        IcSpec spec = dimensionless(fem_spec());
        write_ic_file(folder / "good.h5", IcRecord{spec, IcTable(spec.nx, spec.ny)});
        write_ic_file(folder / "family.h5", family_record());
    }
    ~Bench() {
        ics.reset();
        fs::remove_all(folder);
    }

    std::future<Outcome> ask(const IcSpec& spec, const std::function<bool()>& has_gone = {},
                             const std::string& user = {}) {
        auto promise = std::make_shared<std::promise<Outcome>>();
        ics->request(spec, {[promise](const IcAnswer& a) { promise->set_value({a.origin, {}, a}); },
                            [promise](const proto::Status& s) { promise->set_value({"", s, {}}); },
                            [](const Job&, const JobProgress&) {},
                            {.client = {}, .abandoned = has_gone, .user = user}});
        return promise->get_future();
    }
    void wait_until_running(const std::string& name) {
        const auto is_running = [](const std::shared_ptr<Job>& job) { return job && job->running(); };
        while (!is_running(jobs.find(name))) std::this_thread::yield();
    }
    void cancel(const std::string& name) {
        if (const auto job = jobs.find(name)) return job->cancel();
        FAIL("there is no job " << name);
    }

    fs::path folder;
    JobTable jobs;
    EngineCounters counters;
    std::unique_ptr<IcService> ics;
};

const std::string succeeding = "cp \"$(dirname \"$0\")/good.h5\" \"$3\"";
const std::string endless = "exec sleep 60";

}  // namespace

TEST_CASE("A built table is answered from memory afterwards, and from disk after the memory is gone") {
    Bench bench(succeeding);

    CHECK(bench.ask(fem_spec()).get().origin == "built");
    CHECK(bench.ask(fem_spec()).get().origin == "memory");

    EngineCounters counters;
    IcService again({{{}, bench.folder / "builder"}, 1, 0}, IcStore(bench.folder / "store", [](const std::string&) {}),
                    bench.jobs, counters);
    std::promise<std::string> origin;
    again.request(fem_spec(2, 1), {[&](const IcAnswer& a) { origin.set_value(a.origin); },
                                   [&](const proto::Status& s) { origin.set_value(s.message); },
                                   [](const Job&, const JobProgress&) {}});
    CHECK(origin.get_future().get() == "disk");
    CHECK(bench.counters.builds_started == 1);
    CHECK(counters.builds_started == 0);
}

TEST_CASE("Simultaneous requests join one build") {
    Bench bench("sleep 0.3; " + succeeding);
    std::vector<std::future<Outcome>> results;
    for (int n = 0; n < 8; ++n) results.push_back(bench.ask(fem_spec()));

    for (auto& outcome : results) CHECK(outcome.get().origin == "built");
    CHECK(bench.counters.builds_started == 1);
    CHECK(bench.counters.builds_joined == 7);
}

TEST_CASE("Who may not have tables built gets those that are there, and joins a build of who may") {
    Bench bench("sleep 0.3; " + succeeding, [](const std::string& user) { return user == "alice"; });

    const Outcome denied = bench.ask(fem_spec(), {}, "bob").get();
    CHECK(denied.status.code == proto::StatusCode::permission_denied);
    CHECK(denied.status.reason == proto::reason::build_denied);
    CHECK(bench.ask(fem_spec()).get().status.reason == proto::reason::build_denied);
    CHECK(bench.counters.builds_started == 0);

    auto built = bench.ask(fem_spec(), {}, "alice");
    bench.wait_until_running("build-1");
    CHECK(bench.jobs.find("build-1")->users() == std::vector<std::string>{"alice"});
    auto joined = bench.ask(fem_spec(), {}, "bob");
    CHECK(built.get().origin == "built");
    CHECK(joined.get().origin == "built");
    CHECK(bench.ask(fem_spec(), {}, "bob").get().origin == "memory");
    CHECK(bench.counters.builds_started == 1);
}

TEST_CASE("A build says what it builds, in the lengths of who asked first") {
    Bench bench("sleep 0.3; " + succeeding);
    IcSpec spec = fem_spec();
    spec.accuracy = 1e-3;
    auto outcome = bench.ask(spec);
    bench.wait_until_running("build-1");

    CHECK_THAT(bench.jobs.find("build-1")->description, ContainsSubstring("finite elements, a half-space of nu"));
    CHECK_THAT(bench.jobs.find("build-1")->description, ContainsSubstring(", accuracy 0.001"));
    outcome.wait();
}

TEST_CASE("A failing builder's words reach its callers, and the next request starts anew") {
    Bench bench(R"(echo '{"error": {"field": "x", "message": "The mesh is tangled."}}'; exit 1)");

    const Outcome outcome = bench.ask(fem_spec()).get();

    CHECK(outcome.status.code == proto::StatusCode::internal);
    CHECK(outcome.status.reason == proto::reason::build_failed);
    CHECK_THAT(outcome.status.message, ContainsSubstring("The mesh is tangled."));
    CHECK(bench.ask(fem_spec()).get().status.reason == proto::reason::build_failed);
    CHECK(bench.counters.builds_failed == 2);
}

TEST_CASE("A builder ended by a signal, missing, or leaving no table is a failed build") {
    SECTION("killed") {
        Bench bench("kill -9 $$");
        CHECK_THAT(bench.ask(fem_spec()).get().status.message, ContainsSubstring("signal 9"));
    }
    SECTION("missing") {
        Bench bench("");
        fs::remove(bench.folder / "builder");
        CHECK(bench.ask(fem_spec()).get().status.reason == proto::reason::build_failed);
    }
    SECTION("no table") {
        Bench bench("exit 0");
        CHECK(bench.ask(fem_spec()).get().status.reason == proto::reason::build_failed);
    }
    SECTION("a damaged table") {
        Bench bench("echo nonsense > \"$3\"");
        CHECK(bench.ask(fem_spec()).get().status.reason == proto::reason::build_failed);
    }
}

TEST_CASE("Cancelling a running build answers all its callers and ends the builder") {
    Bench bench(endless);
    auto first = bench.ask(fem_spec());
    bench.wait_until_running("build-1");
    auto second = bench.ask(fem_spec());

    bench.cancel("build-1");

    CHECK(first.get().status.code == proto::StatusCode::cancelled);
    CHECK(second.get().status.code == proto::StatusCode::cancelled);
    CHECK(bench.counters.builds_cancelled == 1);
}

TEST_CASE("A caller that has gone does not count, and is let go of while the build goes on for the others") {
    Bench bench(endless);
    std::atomic<bool> has_gone = false;
    auto leaves = bench.ask(fem_spec(), [&] { return has_gone.load(); });
    auto stays = bench.ask(fem_spec());
    bench.wait_until_running("build-1");
    const auto job = bench.jobs.find("build-1");
    bench.ics->drop_abandoned();
    CHECK(job->callers() == 2);

    has_gone = true;
    CHECK(job->callers() == 1);
    bench.ics->drop_abandoned();

    CHECK(leaves.get().status.code == proto::StatusCode::cancelled);
    CHECK(job->callers() == 1);
    CHECK(bench.jobs.find("build-1") == job);
    bench.cancel("build-1");
    CHECK(stays.get().status.code == proto::StatusCode::cancelled);
    CHECK(job->callers() == 0);
}

TEST_CASE("Cancelling a build that waits for its turn answers at once") {
    Bench bench(endless);
    auto running = bench.ask(fem_spec());
    bench.wait_until_running("build-1");
    IcSpec other = fem_spec();
    other.fem.f = 1.5;
    auto waiting = bench.ask(other);

    bench.cancel("build-2");

    CHECK(waiting.get().status.code == proto::StatusCode::cancelled);
    bench.cancel("build-1");
    CHECK(running.get().status.code == proto::StatusCode::cancelled);
}

TEST_CASE("Stopping ends builds, running and waiting, with the status it is given") {
    Bench bench(endless);
    auto running = bench.ask(fem_spec());
    bench.wait_until_running("build-1");
    IcSpec other = fem_spec();
    other.fem.f = 1.5;
    auto waiting = bench.ask(other);

    bench.ics->stop({proto::StatusCode::unavailable, "ending", "STOPPING", {}, 0});

    CHECK(running.get().status.code == proto::StatusCode::unavailable);
    CHECK(waiting.get().status.code == proto::StatusCode::unavailable);
}

TEST_CASE("Closed-form tables need no builder") {
    Bench bench("exit 1");
    IcSpec spec = fem_spec();
    spec.source = IcSource::analytic;

    CHECK(bench.ask(spec).get().origin == "closed_form");
    CHECK(bench.ask(spec).get().origin == "memory");
}

TEST_CASE("One build of a family serves every Poisson's ratio, every shear modulus and element size") {
    Bench bench("cp \"$(dirname \"$0\")/family.h5\" \"$3\"");
    IcSpec spec = fem_spec(3, 2);
    spec.any_nu = true;

    CHECK(bench.ask(spec).get().origin == "built");
    spec.material = {200, 0.42};
    spec.dx = spec.dy = 0.06;
    const Outcome outcome = bench.ask(spec).get();
    CHECK(outcome.origin == "memory");

    const IcTable table = table_for(*outcome.answer.record, spec);
    IcSpec exact = spec;
    exact.source = IcSource::analytic;
    exact.any_nu = false;
    const IcTable expected = half_space_table(exact);
    REQUIRE(table.nx == 3);
    REQUIRE(table.ny == 2);
    for (std::size_t n = 0; n < table.values.size(); ++n)
        CHECK_THAT(table.values[n], WithinAbs(expected.values[n], 1e-12 * expected.values[0]));
}

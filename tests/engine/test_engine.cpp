// Solves and tables in the caller's own process.
#include "engine/engine.hpp"

#include <unistd.h>

#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <fstream>
#include <thread>

#include "contactd/half_space.hpp"

using namespace contactd;
using namespace contactd::engine;
namespace fs = std::filesystem;

namespace {

ContactProblem ball_on_plate() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(12, 12, 0.5, 0.5);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = Paraboloid{400, 400};
    problem.Fn = 5000;
    return problem;
}

IcSpec block_spec() {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = 3;
    spec.source = IcSource::fem;
    return spec;
}

/// Creates an engine in its own folder, whose builder is a shell script ($3 is the output).
class Workshop {
   public:
    explicit Workshop(const std::string& script) {
        std::string name = (fs::temp_directory_path() / "contactd-engine-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        folder = name;
        const fs::path program = folder / "builder";
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(program, fs::perms::owner_all);
        const IcSpec spec = dimensionless(block_spec());
        write_ic_file(folder / "good.h5", IcRecord{spec, IcTable(spec.nx, spec.ny)});
        EngineSettings settings;
        settings.store_folder = folder / "store";
        settings.tables.command.program = program;
        settings.tables.memory_budget_bytes = 1 << 20;
        settings.tables.log = [this](LogLevel, const std::string& line) { lines.push_back(line); };
        engine = std::make_unique<Engine>(settings);
    }
    ~Workshop() {
        engine.reset();
        fs::remove_all(folder);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    fs::path folder;
    std::vector<std::string> lines;
    std::unique_ptr<Engine> engine;
};

class Impatient final : public Observer {
   public:
    bool cancelled() const override { return asked_++ > 2; }

   private:
    mutable int asked_ = 0;
};

std::size_t threads_of_this_process() {
    const auto tasks = fs::directory_iterator("/proc/self/task");
    return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

}  // namespace

TEST_CASE("A solve on half-spaces makes neither thread nor folder") {
    const fs::path folder = fs::temp_directory_path() / ("contactd-none-" + std::to_string(::getpid()));
    const std::size_t before = threads_of_this_process();
    EngineSettings settings;
    settings.store_folder = folder;
    Engine engine(settings);
    Observer observer;
    const SolveReply reply = engine.solve(ball_on_plate(), observer);
    CHECK(reply.solution.converged());
    CHECK(reply.ics.upper->origin == "closed_form");
    CHECK(reply.ics.lower->origin == "closed_form");  // one table for both bodies, as with a daemon
    CHECK(threads_of_this_process() == before);
    CHECK_FALSE(fs::exists(folder));
}

TEST_CASE("The same problem has the same answer with operators that were cached") {
    Engine engine({});
    Observer observer;
    const SolveReply first = engine.solve(ball_on_plate(), observer), second = engine.solve(ball_on_plate(), observer);
    CHECK(second.solution.pressure == first.solution.pressure);
    CHECK(second.solution.approach == first.solution.approach);
    CHECK(engine.influences().usage().entries == 1);
}

TEST_CASE("Threads that share an engine get the answers of one") {
    Engine engine({});
    Observer observer;
    const SolveReply alone = engine.solve(ball_on_plate(), observer);
    std::vector<SolveReply> replies(6);
    {
        std::vector<std::jthread> threads;
        for (SolveReply& reply : replies)
            threads.emplace_back([&engine, &reply] {
                Observer mine;
                reply = engine.solve(ball_on_plate(), mine);
            });
    }
    for (const SolveReply& reply : replies) CHECK(reply.solution.pressure == alone.solution.pressure);
}

TEST_CASE("A table that finite elements make is built once and found afterwards") {
    Workshop workshop("cat >/dev/null & cp \"$(dirname \"$0\")/good.h5\" \"$3\"");
    Observer observer;
    CHECK(workshop.engine->table(block_spec(), observer).origin == "built");
    CHECK(workshop.engine->table(block_spec(), observer).origin == "memory");
    CHECK(workshop.lines.size() == 2);  // start and end of the build
}

TEST_CASE("A build that fails is reported by the builder's message") {
    Workshop workshop("echo 'no such mesh' >&2; exit 3");
    Observer observer;
    try {
        workshop.engine->table(block_spec(), observer);
        FAIL("there was a table");
    } catch (const StatusError& error) {
        CHECK(error.status().reason == reason::build_failed);
        CHECK(std::string(error.what()).find("no such mesh") != std::string::npos);
    }
}

TEST_CASE("Who does not want to wait for a build any longer ends it") {
    Workshop workshop("exec sleep 60");
    Impatient observer;
    CHECK_THROWS_AS(workshop.engine->table(block_spec(), observer), Cancelled);
    for (int n = 0; n < 200 && workshop.engine->counters().builds_cancelled == 0; ++n)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(workshop.engine->counters().builds_cancelled == 1);
}

TEST_CASE("What cannot be solved as stated is named") {
    Engine engine({});
    Observer observer;
    ContactProblem problem = ball_on_plate();
    problem.bodies.lower.material.nu = 0.7;
    try {
        engine.solve(problem, observer);
        FAIL("it was solved");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "bodies.lower.nu");
    }
}

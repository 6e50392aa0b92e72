// Tests the client's requests, and how it reads valid answers.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>

#include "contactd/client/client.hpp"
#include "contactd/proto/schema.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::echo_gap, fake::echo_gaps, fake::message_of, fake::problem;
using fake::Frames;
using nlohmann::json;

TEST_CASE("A request carries version, method, parameters and timeout", "[client]") {
    json seen;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        seen = request;
        return {{fake::reply(request, {{"job", "build-3"}})}};
    });
    Client client(daemon.endpoint());

    client.cancel_job("build-3", {.timeout = 1234ms});

    CHECK(proto::violations_of("envelope", seen).empty());
    CHECK(seen["method"] == "job.cancel");
    CHECK(seen["params"] == json{{"job", "build-3"}});
    CHECK(seen["timeout_ms"] == 1234);
}

TEST_CASE("A problem goes out and its solution comes back", "[client]") {
    fake::Daemon daemon(echo_gap);
    Client client(daemon.endpoint());

    const auto reply = client.solve(problem());

    CHECK(reply.solution.pressure == fake::gap_of(problem()));
    CHECK(reply.ics.upper->origin == "closed_form");
}

TEST_CASE("Many problems go out and their outcomes come back in order", "[client]") {
    std::size_t frames_sent = 0;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        CHECK(request["method"] == "contact.solve_many");
        frames_sent = frames.size();
        return echo_gaps(request, frames);
    });
    Client client(daemon.endpoint());
    std::vector<ContactProblem> problems(3, problem());
    problems[0].gap = problems[2].gap = std::vector<double>{1, 2, 3, 4, 5, 6};
    problems[1].approach = -1;

    const auto replies = client.solve_many(problems);

    REQUIRE(replies.size() == 3);
    CHECK(std::get<SolveReply>(replies[0]).solution.pressure == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK(std::get<Status>(replies[1]).message == "No.");
    CHECK(std::get<SolveReply>(replies[2]).solution.pressure.size() == 6);
    CHECK(frames_sent == 1);
}

TEST_CASE("Another number of solutions than problems is the daemon's fault", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames& frames) {
        json fewer = request;
        fewer["params"]["problems"].erase(0);
        return echo_gaps(fewer, frames);
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.solve_many(std::vector<ContactProblem>(2, problem())), ProtocolError);
}

TEST_CASE("Of many problems the one that cannot be solved is named", "[client]") {
    fake::Daemon daemon(echo_gaps);
    Client client(daemon.endpoint());
    std::vector<ContactProblem> problems(2, problem());
    problems[1].bodies.upper.material.nu = 0.6;
    try {
        client.solve_many(problems);
        FAIL("nothing was thrown");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "problems[1].bodies.upper.nu");
        CHECK_THAT(error.what(), ContainsSubstring("problems[1].bodies.upper.nu is 0.6; it must"));
    }
}

TEST_CASE("Stresses are asked for and read", "[client]") {
    SubsurfaceRequest request;
    request.grid = Grid::of_elements(2, 1, 0.1, 0.1);
    request.nu = 0.3;
    request.body = ContactBody::upper;
    request.pressure = {1, 2};
    request.points = StressBlock{{0, 1, 2}, {0}, {0, -1}};
    std::vector<std::size_t> shape{2, 1, 3};
    fake::Daemon daemon([&](const json& asked, const Frames& frames) {
        CHECK(asked["method"] == "contact.subsurface");
        const auto read = proto::decode_subsurface_request(asked["params"], frames);
        CHECK(read.body == ContactBody::upper);
        SubsurfaceReply reply;
        for (auto* values : {&reply.stress.xx, &reply.stress.yy, &reply.stress.zz, &reply.stress.xy, &reply.stress.xz,
                             &reply.stress.yz, &reply.stress.von_mises})
            *values = std::vector<double>(6, read.pressure[1]);
        reply.shape = shape;
        const auto [x, y, z] = read.point(0);
        reply.largest = {2, x, y, z};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        return message_of(asked, proto::encode_subsurface_reply(reply, arrays), arrays);
    });
    Client client(daemon.endpoint());

    SECTION("as they come") {
        const auto reply = client.subsurface(request);
        CHECK(reply.stress.xz == std::vector<double>(6, 2));
        CHECK(reply.shape == request.shape());
        CHECK(reply.largest.von_mises == 2);
    }
    SECTION("another shape than asked for is the daemon's fault") {
        shape = {6};
        CHECK_THROWS_AS(client.subsurface(request), ProtocolError);
    }
    SECTION("an array that does not fit the grid is named before anything is sent") {
        request.traction_y = {1, 2, 3};
        CHECK_THROWS_MATCHES(client.subsurface(request), InvalidArgument,
                             MessageMatches(ContainsSubstring("traction_y has 3 values; the grid has 2 elements")));
    }
}

TEST_CASE("Temperatures are asked for and read", "[client]") {
    TemperatureRequest request;
    request.grid = Grid::of_elements(2, 1, 0.1, 0.1);
    request.temperature.upper.bulk_temperature = 20;
    request.velocity = 2e4;
    request.pressure = {1, 2};
    request.traction_x = request.traction_y = request.slip_x = request.slip_y = {0, 0};
    fake::Daemon daemon([&](const json& asked, const Frames& frames) {
        CHECK(asked["method"] == "contact.temperature");
        const auto read = proto::decode_temperature_request(asked["params"], frames);
        CHECK(read.temperature == request.temperature);
        const SurfaceTemperatures reply{read.pressure, {30, 40}, {40, 0, 0, 20, 1, 2, 1000}, {"Warm."}};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        return message_of(asked, proto::encode_temperature_reply(reply, read.grid, arrays), arrays);
    });
    Client client(daemon.endpoint());

    SECTION("as they come") {
        const auto reply = client.temperature(request);
        CHECK(reply.upper_temperature == request.pressure);
        CHECK(reply.temperature.largest == 40);
        CHECK(reply.warnings == std::vector<std::string>{"Warm."});
    }
    SECTION("an array that does not fit the grid is named before anything is sent") {
        request.slip_y = {1, 2, 3};
        CHECK_THROWS_MATCHES(client.temperature(request), InvalidArgument,
                             MessageMatches(ContainsSubstring("slip_y has 3 values; the grid has 2 elements")));
    }
}

TEST_CASE("A table is asked for and read", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        IcReply reply{"key", "built", proto::decode_ic_spec(request["params"]), IcTable(2, 1), {}};
        reply.table(Axis::z, Axis::z, 1, 0) = 0.25;
        reply.evidence.source = "fem";
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const json result = proto::encode_ic_reply(reply, arrays);
        return {{fake::reply(request, result), arrays.take_frames()[0]}};
    });
    Client client(daemon.endpoint());
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = 2;
    spec.ny = 1;
    spec.source = IcSource::fem;
    SECTION("of a mesh") {
        spec.fem.mesh = MeshKind::prism;
    }
    SECTION("of an accuracy, for every Poisson's ratio of a block") {
        spec.body = BodyShape::block;
        spec.load_shape = LoadShape::bilinear;
        spec.accuracy = 1e-2;
        spec.any_nu = true;
        spec.fem.L_over_h = 20;
    }

    const IcReply reply = client.get_ic(spec);

    CHECK(reply.spec == spec);
    CHECK(reply.table.at(Axis::z, Axis::z, -1, 0) == 0.25);
}

TEST_CASE("What the daemon says of itself is read", "[client]") {
    json answer, params;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        params = request["params"];
        return {{fake::reply(request, answer)}};
    });
    Client client(daemon.endpoint());
    const auto example = [](const char* name) { return proto::schema(name)["examples"][0]; };

    SECTION("its versions, limits and counters") {
        answer = example("server.info.result");
        const ServerInfo info = client.info();
        CHECK(info.version == answer["version"].get<std::string>());
        CHECK(info.commit == answer["commit"].get<std::string>());
        CHECK(info.libraries.at("zeromq") == "4.3.5");
        CHECK(info.limits.max_frame_bytes == answer["limits"]["max_frame_bytes"]);
        CHECK(info.limits.max_queue_per_client == answer["limits"]["max_queue_per_client"]);
        CHECK(info.counters.requests == 7);
        CHECK(info.counters.memory_hits == 3);
        CHECK(info.cache.bytes == 1296);
        CHECK(info.queue.builds_running == 0);
        CHECK(info.uptime_seconds == answer["uptime_seconds"]);
    }
    SECTION("a histogram") {
        answer = {{"metrics",
                   {{{"name", "contactd_seconds"},
                     {"type", "histogram"},
                     {"help", "How long."},
                     {"samples",
                      {{{"labels", {{"method", "ic.get"}}},
                        {"count", 3},
                        {"sum", 0.5},
                        {"buckets", {{{"le", 0.1}, {"count", 2}}, {{"le", 1.0}, {"count", 3}}}}}}}}}}};
        const std::vector<Metric> metrics = client.metrics();
        REQUIRE(metrics.size() == 1);
        CHECK(metrics[0].type == "histogram");
        REQUIRE(metrics[0].samples.size() == 1);
        const MetricSample& sample = metrics[0].samples[0];
        CHECK(sample.labels.at("method") == "ic.get");
        CHECK(sample.count == 3);
        CHECK(sample.sum == 0.5);
        REQUIRE(sample.buckets.size() == 2);
        CHECK(sample.buckets[0].le == 0.1);
        CHECK(sample.buckets[0].count == 2);
    }
    SECTION("a counter") {
        answer = example("server.metrics.result");
        CHECK(client.metrics()[1].samples[0].value == 2);
    }
    SECTION("its sessions") {
        answer = example("session.list.result");
        const std::vector<SessionSummary> sessions = client.sessions();
        REQUIRE(sessions.size() == 1);
        CHECK(sessions[0].age_seconds == 12.5);
        CHECK(sessions[0].step == 7);
        CHECK(sessions[0].elements == 1600);
    }
    SECTION("its last solves") {
        answer = example("solves.recent.result");
        answer["solves"].push_back(answer["solves"][0]);
        answer["solves"][1].erase("grid");
        const std::vector<RecentSolve> solves = client.recent_solves();
        REQUIRE(solves.size() == 2);
        CHECK(solves[0].number == 17);
        CHECK(solves[0].method == "contact.solve");
        CHECK(solves[0].grid == Grid::of_elements(40, 40, 0.06, 0.06));
        CHECK(solves[0].forces == std::array{3.1, 0.0, 10.5});
        CHECK(solves[0].has_pressures);
        CHECK_FALSE(solves[1].grid);
    }
    SECTION("the pressures of a solve") {
        answer = example("solves.pressures.result");
        const std::vector<RecentPatch> patches = client.recent_pressures(17);
        REQUIRE(patches.size() == 1);
        CHECK(patches[0].grid.nx == 2);
        CHECK(patches[0].pressure == std::vector{5.25, 0.0});
        CHECK(patches[0].element_division == std::vector<unsigned char>{1, 0});
        CHECK(params == json{{"number", 17}});
    }
    SECTION("its configuration") {
        answer = example("server.config.result");
        CHECK(json::parse(client.config()) == answer["config"]);
    }
    SECTION("tables with their evidence") {
        answer = example("ic.list.result");
        answer["tables"].push_back(answer["tables"][0]);
        answer["tables"][1]["evidence"] = {{"source", "fem"}, {"version", "contactd 0.1.0"}};
        const std::vector<StoredIc> tables = client.stored_ics({}, true);
        REQUIRE(tables.size() == 2);
        CHECK_FALSE(tables[0].evidence);
        CHECK(tables[1].evidence->version == "contactd 0.1.0");
        CHECK(params == json{{"evidence", true}, {"limit", 100}});
    }
    SECTION("its jobs") {
        answer = example("job.list.result");
        answer["jobs"].push_back(answer["jobs"][0]);
        answer["jobs"][1].erase("seconds_left");
        answer["jobs"][1].erase("memory_bytes");
        const std::vector<Job> jobs = client.jobs();
        REQUIRE(jobs.size() == 2);
        CHECK(jobs[0].job == "build-3");
        CHECK(jobs[0].seconds_left == 9.8);
        CHECK_FALSE(jobs[1].seconds_left);
        CHECK(jobs[0].memory_bytes == 870'000'000U);
        CHECK_FALSE(jobs[1].memory_bytes);
    }
    SECTION("tables in quarantine") {
        const std::string key(64, 'a');
        answer = {{"tables", json::array()},
                  {"count", 0},
                  {"bytes", 0},
                  {"quarantined",
                   {{{"key", key}, {"nx", 4}, {"ny", 3}, {"failures", 2}, {"message", "No."}, {"seconds", 7.5}}}}};
        const std::vector<QuarantinedIc> quarantined = client.quarantined_ics();
        REQUIRE(quarantined.size() == 1);
        CHECK(quarantined[0].key == key);
        CHECK(quarantined[0].failures == 2);
        CHECK(quarantined[0].message == "No.");
    }
    SECTION("what was imported") {
        answer = example("ic.import.result");
        FileContents contents;
        contents.attributes["spec/body"] = std::string("half_space");
        contents.attributes["evidence/warnings"] = std::vector<std::string>{"one", "two"};
        contents.datasets["influence_coefficients"] = {{3, 3, 1, 2}, UnsetArray(18, 0.5)};
        const IcImport imported = client.import_ic(contents);
        CHECK(imported.is_new);
        CHECK(imported.use.key == answer["ics"]["key"].get<std::string>());
        CHECK(imported.spec.nx == 12);
        CHECK(params["attributes"] == json{{"spec/body", "half_space"}, {"evidence/warnings", {"one", "two"}}});
        CHECK(params["datasets"]["influence_coefficients"]["$array"]["shape"] == json{3, 3, 1, 2});
    }
    SECTION("how many tables went") {
        answer = example("ic.delete.result");
        CHECK(client.delete_ic(answer["key"]) == 1);
        CHECK(params == json{{"key", answer["key"]}});
    }
}

TEST_CASE("The tables of the store are asked for page by page", "[client]") {
    const std::string first(64, 'a'), second(64, 'b');
    std::vector<json> asked;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        asked.push_back(request["params"]);
        const bool last = asked.size() == 2;
        json page{{"tables", {{{"key", last ? second : first}, {"nx", 4}, {"ny", 3}, {"bytes", 99}}}},
                  {"count", 2},
                  {"bytes", 198},
                  {"quarantined", json::array()}};
        if (!last) page["next"] = "a.4x3";
        return {{fake::reply(request, page)}};
    });

    const std::vector<StoredIc> tables = Client(daemon.endpoint()).stored_ics();

    REQUIRE(tables.size() == 2);
    CHECK(tables[0].key == first);
    CHECK(tables[1].key == second);
    CHECK(tables[1].nx == 4);
    CHECK(tables[1].bytes == 99);
    CHECK(asked == std::vector<json>{json::object(), {{"after", "a.4x3"}}});
}

TEST_CASE("A table is exported as a file", "[client]") {
    json params;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        params = request["params"];
        CHECK(proto::violations_of("ic.export.params", params).empty());
        IcUse use{"memory", std::string(64, 'a'), {}};
        use.evidence.source = "analytic";
        if (params["format"] == "contact")
            return {{fake::reply(request, proto::encode_contact_text_reply("1 1\n", use, use))}};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const std::vector<unsigned char> file{0x89, 'H', 0, 0xff};
        return message_of(request, proto::encode_hdf5_reply(file, use, arrays), arrays);
    });
    Client client(daemon.endpoint());
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = 2;

    SECTION("of the store") {
        CHECK(client.export_ic(spec) == std::string("\x89H\0\xff", 4));
        CHECK_FALSE(params.contains("lower"));
    }
    SECTION("for the CONTACT program, of two bodies") {
        CHECK(client.export_ic(spec, FileFormat::contact, Material{200, 0.3}) == "1 1\n");
        CHECK(params["lower"]["G"] == 200);
    }
}

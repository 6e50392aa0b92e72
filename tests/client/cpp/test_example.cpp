// Tests the example with a real daemon in a temporary folder.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <string>

#include <reproc++/drain.hpp>
#include <reproc++/run.hpp>

#include "contactd/client/client.hpp"
#include "contactd/client/session.hpp"
#include "own_daemon.hpp"

using namespace std::chrono_literals;
using Catch::Approx;
using contactd::client::ServerInfo;

namespace {

double number_behind(const std::string& word, const std::string& text) {
    std::smatch found;
    REQUIRE(std::regex_search(text, found, std::regex(word + R"(\s+(-?[0-9.e+-]+))")));
    return std::stod(found[1]);
}

}  // namespace

TEST_CASE("The example solves the Cattaneo problem through a daemon", "[client][daemon]") {
    Daemon daemon;
    contactd::client::Client client(daemon.endpoint(), {.connect_timeout = 20s});
    REQUIRE(client.health() == "serving");
    std::string output;

    reproc::sink::string sink(output);
    const auto [status, error] =
        reproc::run(std::vector<std::string>{EXAMPLE, daemon.endpoint()}, reproc::options{}, sink, sink);

    INFO(output);
    CHECK_FALSE(error);
    CHECK(status == 0);
    CHECK(number_behind("Fn", output) == Approx(9.19731113).epsilon(1e-5));
    CHECK(std::abs(number_behind("Fx", output)) == Approx(3.22211266).epsilon(1e-5));
    CHECK(number_behind("area", output) == Approx(3.1680).epsilon(1e-4));
    CHECK(output.find("216 elements in adhesion, 664 in slip") != std::string::npos);
}

TEST_CASE("A daemon answers every call of the client", "[client][daemon]") {
    Daemon daemon;
    contactd::client::Client client(daemon.endpoint(), {.connect_timeout = 20s});

    const ServerInfo info = client.info();
    CHECK(info.protocol == 1);
    CHECK(info.protocol_versions == std::vector<int>{1});
    CHECK(info.libraries.contains("zeromq"));
    CHECK(info.limits.max_frames == 8192);
    CHECK(info.limits.max_lease_seconds > 0);
    CHECK(info.cache.budget_bytes > 0);
    CHECK(client.describe().starts_with("{"));
    CHECK(client.jobs().empty());
    CHECK(client.sessions().empty());
    CHECK_THROWS_AS(client.cancel_job("build-77"), contactd::StatusError);
    contactd::IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = 4;
    spec.ny = 3;
    const contactd::IcReply reply = client.get_ic(spec);
    CHECK(reply.origin == "closed_form");
    CHECK(reply.spec == spec);
    CHECK(client.info().counters.closed_form == 1);
    CHECK(reply.table(contactd::Axis::z, contactd::Axis::z, 0, 0) > 0);

    contactd::ContactProblem problem;
    problem.grid = contactd::Grid::of_elements(8, 8, 0.3, 0.3);
    problem.bodies = {{200, 0.42}, {contactd::Material::rigid()}};
    problem.gap = contactd::Paraboloid{50, 50};
    problem.Fn = 9.2;
    contactd::Shift pulled;
    pulled.force.Fx = 1e6;
    std::vector<contactd::ContactProblem> problems(2, problem);
    problems[1].friction = contactd::FrictionLaw{{0.4}};
    problems[1].motion = pulled;
    const auto replies = client.solve_many(problems);
    CHECK(std::get<contactd::SolveReply>(replies[0]).solution.forces.Fn == Approx(9.2).epsilon(1e-6));
    CHECK(std::get<contactd::Status>(replies[1]).violations[0].field == "friction.force");

    contactd::SubsurfaceRequest inside;
    inside.grid = problem.grid;
    inside.nu = 0.42;
    inside.body = contactd::ContactBody::upper;
    inside.pressure = std::get<contactd::SolveReply>(replies[0]).solution.pressure;
    inside.points = contactd::StressBlock{{0.15}, {0.15}, {0, -0.4, -0.8}};
    const auto stresses = client.subsurface(inside);
    CHECK(stresses.shape == std::vector<std::size_t>{3, 1, 1});
    CHECK(stresses.stress.zz[0] == Approx(-inside.pressure[4 * 8 + 4]).epsilon(1e-9));
    CHECK(stresses.largest.depth() == 0.4);
}

TEST_CASE("Tables leave the daemon as files, and its store is empty without builds", "[client][daemon]") {
    Daemon daemon;
    contactd::client::Client client(daemon.endpoint(), {.connect_timeout = 20s});
    contactd::IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = 4;
    spec.ny = 3;

    CHECK(client.export_ic(spec).find("HDF") != std::string::npos);
    const std::string of_two = client.export_ic(spec, contactd::FileFormat::contact, contactd::Material{200, 0.3});
    CHECK(of_two != client.export_ic(spec, contactd::FileFormat::contact));
    const contactd::FileContents contents = client.export_contents(spec);
    CHECK(contents.datasets.at("influence_coefficients").shape == std::vector<std::size_t>{3, 3, 3, 4});
    CHECK_THROWS_AS(client.import_ic(contents), contactd::StatusError);  // of a closed form
    CHECK_THROWS_AS(client.import_ic({}), contactd::StatusError);
    CHECK(client.stored_ics().empty());
    CHECK(client.quarantined_ics().empty());
    CHECK_THROWS_AS(client.delete_ic(std::string(64, 'a')), contactd::client::StatusError);
}

TEST_CASE("A daemon tells what is measured of it", "[client][daemon]") {
    Daemon daemon;
    contactd::client::Client client(daemon.endpoint(), {.connect_timeout = 20s});
    client.health();

    const std::vector<contactd::client::Metric> metrics = client.metrics();

    const auto named = [&](const std::string& name) {
        const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const auto& m) { return m.name == name; });
        REQUIRE(found != metrics.end());
        return *found;
    };
    CHECK(named("contactd_open_requests").type == "gauge");
    const auto solves = named("contactd_solves_total");
    REQUIRE(solves.samples.size() == 2);
    CHECK(solves.samples[0].labels.contains("converged"));
    CHECK(solves.samples[0].value == 0);
}

TEST_CASE("A session steps, goes back and comes to the same", "[client][daemon]") {
    Daemon daemon;
    contactd::client::Client client(daemon.endpoint(), {.connect_timeout = 20s});
    contactd::SessionSpec spec;
    spec.setup.grid = contactd::Grid::of_elements(12, 12, 0.2, 0.2);
    spec.setup.bodies = {{200, 0.42}, {200, 0.42}};
    spec.load.gap = contactd::Paraboloid{50, 50};
    contactd::Shift shift;
    shift.rigid_shift.x = 0.004;
    spec.setup.friction = contactd::FrictionLaw{{0.4}};
    spec.load.motion = shift;
    contactd::StepInput input;
    input.approach = 0.02;
    input.fields = {contactd::SolutionField::pressure};
    {
        contactd::client::Session session(client, spec);
        CHECK(session.bytes() > 0);
        CHECK(session.ics().lower->origin != "");
        REQUIRE(client.sessions().size() == 1);
        CHECK(client.sessions()[0].elements == 144);
        const auto first = session.step(input);
        const contactd::client::SavedState state = session.save();
        const auto second = session.step(input);
        session.restore(state);
        CHECK(session.step_number() == 1);
        const auto again = session.step(input);

        CHECK(first.solution.pressure.size() == 144);
        CHECK(std::abs(second.solution.forces.Fx) > std::abs(first.solution.forces.Fx));  // shifted further
        CHECK(again.step == 2);
        CHECK(again.solution.forces.Fx == second.solution.forces.Fx);
        session.forget(state);
        CHECK_THROWS_AS(session.restore(state), contactd::StatusError);
        session.close();
        CHECK_THROWS_AS(session.step(input), contactd::StatusError);
    }
    std::string name;
    {
        contactd::client::Session left(client, spec);
        CHECK(left.step(input).step == 1);
        name = left.release();
    }
    contactd::client::Client elsewhere(daemon.endpoint());
    auto joined = contactd::client::Session::join(elsewhere, name);
    CHECK(joined.step_number() == 1);
    CHECK(joined.step(input).solution.pressure.size() == 144);
    joined.close();
    CHECK_THROWS_AS(contactd::client::Session::join(elsewhere, name), contactd::StatusError);
    const contactd::client::Session other(client, spec);
    CHECK(other.lease_seconds() == 300);
}

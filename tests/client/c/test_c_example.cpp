// Tests the example in C with a real daemon.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <regex>
#include <string>
#include <vector>

#include <reproc++/drain.hpp>
#include <reproc++/run.hpp>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"

using Catch::Approx;

TEST_CASE("The example in C shifts the sphere of the Cattaneo problem in two steps", "[c]") {
    Daemon daemon;
    const Place place(daemon.endpoint());
    REQUIRE(contactd_ping(place) == CONTACTD_OK);
    std::string output;
    reproc::sink::string sink(output);

    const auto [status, error] = reproc::run(std::vector<std::string>{EXAMPLE, daemon.endpoint()}, {}, sink, sink);

    INFO(output);
    CHECK_FALSE(error);
    CHECK(status == 0);
    std::smatch found;
    REQUIRE(std::regex_search(output, found, std::regex(R"(step 2: Fn (\S+) N, Fx (\S+) N)")));
    CHECK(std::stod(found[1]) == Approx(9.19731113).epsilon(1e-5));
    CHECK(std::stod(found[2]) == Approx(-3.22211266).epsilon(1e-4));  // like one step, of which a shift consists
}

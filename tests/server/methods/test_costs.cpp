#include <catch2/catch_test_macros.hpp>

#include <string>

#include "contactd/proto/status.hpp"
#include "methods/costs/costs.hpp"

using namespace contactd;
using namespace contactd::server;
using nlohmann::json;

namespace {

const Config& defaults() {
    static const Config config = config_from_json(json::object());
    return config;
}

double bytes_of_wheel(const std::string& conformal, double size) {
    return cost_of_wheel_rail({{"setup", {{"conformal", conformal}, {"dx", size}, {"dy", size}}}}, defaults()).bytes;
}

json slab() {
    return {{"G", 82000},
            {"nu", 0.28},
            {"ics",
             {{"source", "analytic"},
              {"body", "longitudinally_uniform"},
              {"section", {{"slab", {{"thickness", 10}, {"width", 100}}}}}}}};
}

json problem(const json& upper, const json& lower) {
    return {{"grid", {{"nx", 30}, {"ny", 300}, {"dx", 0.08}, {"dy", 0.008}}},
            {"bodies", {{"upper", upper}, {"lower", lower}}}};
}

}  // namespace

TEST_CASE("Curved contacts of half-spaces whose tables are flat take no more than plane ones") {
    for (const double size : {0.2, 0.1, 0.03})
        for (const char* conformal : {"half_space", "rotated_displacements"}) {
            CAPTURE(conformal, size);
            CHECK(bytes_of_wheel(conformal, size) == bytes_of_wheel("off", size));
        }
    CHECK(bytes_of_wheel("rotated", 0.1) > 2 * bytes_of_wheel("off", 0.1));
    CHECK(bytes_of_wheel("auto", 0.1) == bytes_of_wheel("rotated", 0.1));
}

TEST_CASE("A contact of a wheel that has not been found is not refused for its memory") {
    for (const double size : {0.2, 0.1, 0.05, 0.01})
        for (const char* conformal : {"off", "half_space", "rotated", "fem", "auto"}) {
            CAPTURE(conformal, size);
            const json params = {{"setup", {{"conformal", conformal}, {"dx", size}, {"dy", size}}}};
            CHECK_NOTHROW(check_cost(cost_of_wheel_rail(params, defaults()), defaults()));
        }
}

TEST_CASE("Derivatives with friction cost the memory of their linear equations") {
    json params = problem({{"G", 82000}, {"nu", 0.28}}, {{"G", 20000}, {"nu", 0.1}});
    const auto bytes = [&](bool derivatives) {
        params["derivatives"] = derivatives;
        return cost_of_solve(params, defaults()).bytes;
    };
    CHECK(bytes(true) == bytes(false));
    params["friction"] = {{"mu", 0.3}, {"rolling", {{"xi", 1e-3}}}};
    CHECK(bytes(true) > 1.3 * bytes(false));
}

TEST_CASE("Costs of longitudinally uniform bodies count those that have strips, and steps of their own tables") {
    const json rigid = {{"rigid", true}}, half_space = {{"G", 82000}, {"nu", 0.28}};
    const auto bytes = [](const json& params) { return cost_of_solve(params, defaults()).bytes; };
    const json one = problem(rigid, slab()), two = problem(slab(), slab());
    CHECK(bytes(problem(slab(), half_space)) == bytes(one));
    CHECK(bytes(two) > 1.3 * bytes(one));
    json both = problem(half_space, half_space), other_rigid = problem(rigid, half_space);
    both["ics"] = other_rigid["ics"] = slab()["ics"];
    CHECK(bytes(both) == bytes(two));
    CHECK(bytes(other_rigid) == bytes(one));

    const auto rolling = [&](double dq) {
        json rolls = one;
        rolls["friction"] = {{"mu", 0.3}, {"rolling", {{"xi", 0.001}}}};
        if (dq != 0) rolls["friction"]["rolling"]["dq"] = dq;
        return bytes(rolls);
    };
    CHECK(rolling(0.16) == rolling(0));
    CHECK(rolling(0.05) > 1.3 * rolling(0));
}

TEST_CASE("Columns of half-spaces have the cost of a plane") {
    json plane = problem({{"G", 82000}, {"nu", 0.28}}, {{"rigid", true}}), curved = plane;
    plane["ics"] = curved["ics"] = {{"source", "analytic"}};
    curved["columns"] = {{"frames", json::array()}};
    CHECK(cost_of_solve(curved, defaults()).bytes == cost_of_solve(plane, defaults()).bytes);
}

// Tests contact.temperature, and temperatures in contact.solve.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

ThermalBodies bodies() {
    ThermalBodies bodies;
    bodies.upper.bulk_temperature = 0.1 + 0.2;
    bodies.lower = ThermalBody{140, 0, 1.0 / 3, 7000};
    return bodies;
}

}  // namespace

TEST_CASE("A request of temperatures comes back as it went", "[temperature]") {
    TemperatureRequest request;
    request.grid = {3, 1, 0.5, 0.25, -1, 2};
    request.temperature = bodies();
    request.velocity = 2e4;
    request.chi = 3.141592653589793;
    request.pressure = {0, 1, 2};
    request.traction_x = {0, -0.1, -1.0 / 3};
    request.traction_y = {0, 0, 1e-300};
    request.slip_x = {0, 0.01, 0.02};
    request.slip_y = {0, -0.01, 0};
    if (GENERATE(true, false)) {  // of a layer that flows
        request.temperature.plastic_share = 0.9;
        request.flow_x = {0, 1e-3, 1.0 / 7};
        request.flow_y = {0, -1e-3, 0};
        request.upper_speed = 1.9e4;
    }
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = encode_temperature_request(request, arrays);
    CHECK(violations_of("contact.temperature.params", params).empty());
    const Frames frames = arrays.take_frames();
    const TemperatureRequest back = decode_temperature_request(json::parse(dump(params)), frames);
    CHECK(back.grid == request.grid);
    CHECK(back.temperature == request.temperature);
    CHECK((back.velocity == request.velocity && back.chi == request.chi));
    CHECK(back.upper_speed == request.upper_speed);
    CHECK((back.pressure == request.pressure && back.traction_x == request.traction_x));
    CHECK((back.traction_y == request.traction_y && back.slip_x == request.slip_x && back.slip_y == request.slip_y));
    CHECK((back.flow_x == request.flow_x && back.flow_y == request.flow_y));
}

TEST_CASE("Temperatures come back as they went", "[temperature]") {
    const Grid grid{2, 1, 1, 1, 0, 0};
    const SurfaceTemperatures reply{{1.0 / 3, 40}, {2, 30}, {40, 1.5, 0.5, 41, 42, 7, 1e6, 2e6, 5000}, {"Warm."}};
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = encode_temperature_reply(reply, grid, arrays);
    CHECK(violations_of("contact.temperature.result", result).empty());
    const SurfaceTemperatures back = decode_temperature_reply(json::parse(dump(result)), grid, {});
    CHECK(back.upper_temperature == reply.upper_temperature);
    CHECK(back.lower_temperature == reply.lower_temperature);
    CHECK(back.temperature == reply.temperature);
    CHECK(back.warnings == reply.warnings);
}

TEST_CASE("Heat of a problem comes back as it went", "[temperature]") {
    json params = wire::solve_params();
    ContactProblem problem = decode_problem(params, {});
    problem.friction->temperature =
        TemperatureFriction{-0.1, 20, 1.0 / 3, GENERATE(std::optional<FrictionMemory>{}, FrictionMemory{1e-3, 10})};
    for (const ThermalBodies& heat : {ThermalBodies{}, bodies()}) {
        problem.temperature = heat;
        ArrayWriter arrays(ArrayEncoding::list);
        params = encode_problem(problem, arrays);
        CHECK(violations_of("contact.solve.params", params).empty());
        const ContactProblem back = decode_problem(json::parse(dump(params)), {});
        CHECK(back.temperature == problem.temperature);
        CHECK(back.friction == problem.friction);
    }
}

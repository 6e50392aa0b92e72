// Tests temperatures of surfaces with given tractions and slips against closed forms (Ertz and Knothe 2002; Carslaw and
// Jaeger).
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/error.hpp"
#include "contactd/surface_temperature.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Values = std::vector<double>;
using Heat = std::function<double(double x, double y)>;

constexpr double steel = 13.290033860;  // effusivity (N/(mm s^0.5 K))

/// Uses a slip of 1 mm/s and a traction that produces this heat, in contact where there is heat. Slip is across the
/// rows, so that both surfaces pass through the contact at the rolling velocity.
TemperatureRequest request_of(const Grid& grid, double velocity, const Heat& heat) {
    TemperatureRequest request;
    request.grid = grid;
    request.velocity = velocity;
    request.traction_x = request.slip_x = Values(grid.size());
    request.slip_y.assign(grid.size(), 1 / velocity);
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            request.pressure.push_back(heat(grid.x(ix), grid.y(iy)));
            request.traction_y.push_back(-request.pressure.back());
        }
    return request;
}

SurfaceTemperatures found(const TemperatureRequest& request) {
    Observer none;
    return surface_temperature(request, none);
}

double unit_rise(double velocity, double both = 2 * steel) {
    return 1 / (both * std::sqrt(std::numbers::pi * velocity));
}

/// The leading edge is at x = 4, the contact is 8 long, and the grid twice that.
TemperatureRequest uniform_heat(double velocity = 2e4) {
    return request_of({32, 1, 0.5, 1, -12, -0.5}, velocity, [](double x, double) { return x > -4 ? 3e4 : 0; });
}

ThermalBody at(double temperature) {
    ThermalBody body;
    body.bulk_temperature = temperature;
    return body;
}

std::string refused(const TemperatureRequest& request) {
    try {
        found(request);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("A uniform heat raises temperatures as roots of distances, in contact and behind it", "[temperature]") {
    const TemperatureRequest request = uniform_heat();
    const SurfaceTemperatures answer = found(request);
    for (int i = 0; i < 32; ++i) {
        const double d = 4 - request.grid.x(i), behind = std::max(0.0, d - 8);
        const double right = 2 * 3e4 * unit_rise(2e4) * (std::sqrt(d) - std::sqrt(behind));
        CHECK_THAT(answer.upper_temperature[static_cast<std::size_t>(i)], WithinRel(right, 1e-8));
    }
    CHECK(answer.lower_temperature == answer.upper_temperature);
    CHECK(answer.temperature.largest == answer.temperature.rise);
    CHECK(answer.temperature.x == -3.75);
    CHECK_THAT(answer.temperature.heat_upper + answer.temperature.heat_lower, WithinRel(3e4 * 8, 1e-12));
    CHECK(answer.temperature.heat_upper == answer.temperature.heat_lower);
    CHECK(answer.warnings.empty());
}

TEST_CASE("The heat of a Hertzian strip raises its temperature by the closed form", "[temperature]") {
    constexpr double a = 5.878886, q0 = 0.3 * 770.5259 * 999.9, V = 3e4;
    const auto heat = [](double x, double) { return std::abs(x) < a ? q0 * std::sqrt(1 - x * x / (a * a)) : 0; };
    const double unit = q0 * std::sqrt(a) * unit_rise(V);
    CHECK_THAT(unit * 2.188306674, WithinRel(150.28967, 1e-6));
    for (const auto& [dx, right] : {std::pair(0.1, 150.2863), std::pair(0.05, 150.2840), std::pair(0.02, 150.2892)}) {
        const int n = 2 * static_cast<int>(std::ceil(a / dx)) + 2;
        const SurfaceTemperatures answer = found(request_of(Grid::of_elements(n, 1, dx, 1), V, heat));
        CHECK_THAT(answer.temperature.rise, WithinRel(unit * 2.188306674, 1e-4));
        CHECK_THAT(answer.temperature.rise, WithinRel(right, 2e-4));
        CHECK_THAT(answer.temperature.x / a, WithinAbs(-0.652229515, dx / a));
    }
}

TEST_CASE("Far behind the contact all heat counts as from one line", "[temperature]") {
    const Grid grid{4000, 1, 0.5, 1, -1996, -0.5};
    const auto heat = [](double x, double) { return x > 0 ? 1e4 * (1 + x) : 0; };
    const TemperatureRequest request = request_of(grid, 2e4, heat);
    double sum = 0;
    for (const double q : request.pressure) sum += q * grid.dx;
    const double d = 4 - grid.x(0);
    CHECK_THAT(found(request).upper_temperature[0] * std::sqrt(d), WithinRel(sum * unit_rise(2e4), 2e-3));
}

TEST_CASE("Bodies of different temperature meet in between, and part again behind the contact", "[temperature]") {
    TemperatureRequest request = uniform_heat();
    request.slip_y.assign(32, 0);
    request.temperature = {at(0), at(150)};
    const SurfaceTemperatures answer = found(request);
    for (std::size_t i = 16; i < 32; ++i) {
        CHECK_THAT(answer.upper_temperature[i], WithinRel(75, 1e-12));
        CHECK_THAT(answer.lower_temperature[i], WithinRel(75, 1e-12));
    }
    for (int i = 0; i < 16; ++i) {
        const double share = 2 / std::numbers::pi * std::asin(std::sqrt(8 / (4 - request.grid.x(i))));
        CHECK_THAT(answer.upper_temperature[static_cast<std::size_t>(i)], WithinRel(75 * share, 1e-12));
        CHECK_THAT(answer.lower_temperature[static_cast<std::size_t>(i)], WithinRel(150 - 75 * share, 1e-12));
    }
    // Half of the difference remains if the contact is half as long as the distance from its leading edge, here a
    // quarter of a millimetre beyond the centre of the last element.
    CHECK_THAT(answer.upper_temperature[0], WithinAbs(37.5, 0.7));
    CHECK_THAT(answer.lower_temperature[0], WithinAbs(112.5, 0.7));
}

TEST_CASE("A body that conducts no heat leaves all of it to the other", "[temperature]") {
    TemperatureRequest request = uniform_heat();
    request.temperature = {at(20), at(90)};
    request.temperature.lower->conductivity = 0;
    const SurfaceTemperatures answer = found(request);
    CHECK(answer.temperature.heat_lower == 0);
    const double right = 20 + 2 * 3e4 * unit_rise(2e4, steel) * std::sqrt(4 - request.grid.x(16));
    CHECK_THAT(answer.upper_temperature[16], WithinRel(right, 1e-8));
    CHECK_THAT(answer.lower_temperature[16], WithinRel(right, 1e-8));
    request.temperature.upper.conductivity = 0;
    CHECK(refused(request) == "temperature.upper.conductivity");
}

TEST_CASE("The rise is linear in the heat, falls by the root of the velocity, and bulk shifts all", "[temperature]") {
    const SurfaceTemperatures once = found(uniform_heat());
    TemperatureRequest twice = uniform_heat();
    for (double& p : twice.traction_y) p *= 2;
    CHECK_THAT(found(twice).temperature.rise, WithinRel(2 * once.temperature.rise, 1e-12));
    CHECK_THAT(found(uniform_heat(8e4)).temperature.rise, WithinRel(once.temperature.rise / 2, 1e-12));
    TemperatureRequest warm = uniform_heat();
    warm.temperature = {at(50), {}};
    const SurfaceTemperatures shifted = found(warm);
    for (std::size_t i = 0; i < 32; ++i)
        CHECK_THAT(shifted.lower_temperature[i], WithinRel(50 + once.lower_temperature[i], 1e-12));
}

TEST_CASE("Rolling the other way is the mirror image", "[temperature]") {
    TemperatureRequest request = uniform_heat();
    request.temperature = {at(0), at(30)};
    request.pressure[16] = 0;  // the trailing edge is elsewhere
    const SurfaceTemperatures forwards = found(request);
    request.chi = std::numbers::pi;
    for (auto* values : {&request.pressure, &request.traction_y, &request.slip_y})
        std::reverse(values->begin(), values->end());
    SurfaceTemperatures backwards = found(request);
    std::reverse(backwards.upper_temperature.begin(), backwards.upper_temperature.end());
    CHECK(backwards.upper_temperature == forwards.upper_temperature);
}

TEST_CASE("What temperatures leave out is told", "[temperature]") {
    TemperatureRequest request = uniform_heat(20);
    CHECK(found(request).warnings.size() == 1);
    request = uniform_heat();
    request.pressure[20] = 0;
    REQUIRE(found(request).warnings.size() == 1);
    CHECK(found(request).warnings[0].find("gaps") != std::string::npos);
    request = uniform_heat();
    request.temperature.upper.bulk_temperature = 900;
    CHECK(found(request).warnings.size() == 1);
}

TEST_CASE("Without contact both surfaces have their bulk temperature", "[temperature]") {
    TemperatureRequest request = uniform_heat();
    request.pressure.assign(32, 0);
    request.temperature = {at(5), at(30)};
    const SurfaceTemperatures answer = found(request);
    CHECK(answer.upper_temperature == Values(32, 5));
    CHECK(answer.lower_temperature == Values(32, 30));
    CHECK(answer.temperature.largest == 30);
    CHECK(answer.temperature.largest_upper == 5);
    CHECK(answer.temperature.largest_lower == 30);
    CHECK(answer.temperature.peclet == 0);
    CHECK(answer.warnings.empty());
}

TEST_CASE("Temperatures that nobody knows are refused by name", "[temperature]") {
    const TemperatureRequest right = uniform_heat();
    TemperatureRequest wrong = right;
    wrong.chi = 0.1;
    CHECK(refused(wrong) == "chi");
    wrong = right;
    wrong.velocity = 0;
    CHECK(refused(wrong) == "velocity");
    wrong = right;
    wrong.slip_y.pop_back();
    CHECK(refused(wrong) == "slip_y");
    wrong = right;
    wrong.traction_x[3] = NAN;
    CHECK(refused(wrong) == "traction_x");
    wrong = right;
    wrong.flow_x.assign(32, 0);
    CHECK(refused(wrong) == "flow_x");
    wrong = right;
    wrong.temperature.upper.density = 0;
    CHECK(refused(wrong) == "temperature.upper.density");
}

// Tests surfaces that pass through the contact at their own speeds: the partition of the heat (Blok 1937), and the heat
// of layers that flow.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/error.hpp"
#include "contactd/surface_temperature.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Values = std::vector<double>;

constexpr double steel = 13.290033860;  // effusivity (N/(mm s^0.5 K))
constexpr double velocity = 1e4, heat = 3e4;
constexpr int nx = 32;

/// Creates rows in contact from x = -4 to 4, with a uniform heat, each with its own slip of the upper body along x; no
/// slip, no heat.
TemperatureRequest rows_that_slip(const Values& slips) {
    TemperatureRequest request;
    request.grid = {nx, static_cast<int>(slips.size()), 0.5, 1, -11, -0.5};
    request.velocity = velocity;
    request.traction_y = request.slip_y = Values(request.grid.size());
    for (const double slip : slips)
        for (int ix = 0; ix < nx; ++ix) {
            const bool touches = std::abs(request.grid.x(ix)) < 4;
            request.pressure.push_back(touches ? 1 : 0);
            request.slip_x.push_back(touches ? slip : 0);
            request.traction_x.push_back(touches && slip != 0 ? -heat / (velocity * slip) : 0);
        }
    return request;
}

ThermalBody body_of(double effusivity, double bulk_temperature = 0) {
    ThermalBody body;
    body.bulk_temperature = bulk_temperature;
    body.conductivity = std::pow(1e3 * effusivity, 2) / (body.density * body.heat_capacity);
    return body;
}

SurfaceTemperatures found(const TemperatureRequest& request) {
    Observer none;
    return surface_temperature(request, none);
}

/// Returns the sum of effusivities times roots of speeds, if the upper surface slips by w in the rolling direction.
double sum_of_roots(double upper, double lower, double w) {
    return upper * std::sqrt(velocity * (1 - w / 2)) + lower * std::sqrt(velocity * (1 + w / 2));
}

bool says(const SurfaceTemperatures& answer, const std::string& text) {
    return std::ranges::any_of(answer.warnings,
                               [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("Each surface takes heat by its own speed", "[temperature]") {
    const double w = GENERATE(0.04, 1.0, 1.8, -1.0, -0.3);
    TemperatureRequest request = rows_that_slip({w});
    const SurfaceTemperatures answer = found(request);
    for (int ix = 0; ix < nx; ++ix) {
        const double d = 4 - request.grid.x(ix), behind = std::max(0.0, d - 8);
        const double right = d < 0 ? 0
                                   : 2 * heat * (std::sqrt(d) - std::sqrt(behind)) /
                                         (std::sqrt(std::numbers::pi) * sum_of_roots(steel, steel, w));
        CHECK_THAT(answer.upper_temperature[static_cast<std::size_t>(ix)], WithinRel(right, 1e-8));
    }
    CHECK(answer.lower_temperature == answer.upper_temperature);
    const ContactTemperature& all = answer.temperature;
    CHECK_THAT(all.heat_upper + all.heat_lower, WithinRel(heat * 8, 1e-12));
    CHECK_THAT(all.heat_upper / all.heat_lower, WithinRel(std::sqrt((1 - w / 2) / (1 + w / 2)), 1e-12));
    const double slower = velocity * (1 - std::abs(w) / 2), diffusivity = 50 / (7850 * 450e-6);
    CHECK_THAT(all.peclet, WithinRel(slower * 8 / (2 * diffusivity), 1e-12));
    CHECK(answer.warnings.empty());
}

TEST_CASE("Bodies of different heat and temperature meet by their speeds, too", "[temperature]") {
    const double w = -0.8, chi = GENERATE(0.0, std::numbers::pi);
    TemperatureRequest request = rows_that_slip({chi == 0 ? w : -w});
    request.chi = chi;
    request.temperature = {body_of(13, 20), body_of(5, 110)};
    const double upper = 13 * std::sqrt(1.4), lower = 5 * std::sqrt(0.6);
    const double meet = (upper * 20 + lower * 110) / (upper + lower);
    const double rise = 2 * heat * std::sqrt(0.25) / std::sqrt(std::numbers::pi * velocity) / (upper + lower);
    const SurfaceTemperatures answer = found(request);
    const std::size_t first = chi == 0 ? 29 : 14;  // in contact
    CHECK_THAT(answer.upper_temperature[first], WithinRel(meet + rise, 1e-8));
    CHECK_THAT(answer.lower_temperature[first], WithinRel(meet + rise, 1e-8));
    CHECK_THAT(answer.temperature.heat_upper / (heat * 8), WithinRel(upper / (upper + lower), 1e-12));
}

TEST_CASE("A locked wheel gives its heat to the rail", "[temperature]") {
    const SurfaceTemperatures answer = found(rows_that_slip({-2}));  // speed of the rail over that of the wheel
    CHECK_THAT(answer.temperature.heat_upper, WithinRel(heat * 8, 1e-5));
    CHECK(answer.temperature.heat_lower < 1e-5 * heat * 8);
    CHECK_THAT(answer.temperature.rise,
               WithinRel(2 * heat * std::sqrt(7.75) / (steel * std::sqrt(std::numbers::pi * 2 * velocity)), 1e-5));
    CHECK(answer.temperature.peclet == 0);
    CHECK(says(answer, "Peclet"));
}

TEST_CASE("Spin gives each row speeds of its own", "[temperature]") {
    const Values slips{-0.4, -0.2, 0.2, 0.4};
    const SurfaceTemperatures answer = found(rows_that_slip(slips));
    for (std::size_t row = 0; row < slips.size(); ++row) {
        const double right =
            2 * heat * std::sqrt(7.75) / (std::sqrt(std::numbers::pi) * sum_of_roots(steel, steel, slips[row]));
        CHECK_THAT(answer.upper_temperature[row * nx + 14], WithinRel(right, 1e-8));
    }
    // The heat of one side into the lower body equals that of the other side into the upper one.
    CHECK_THAT(answer.temperature.heat_upper, WithinRel(answer.temperature.heat_lower, 1e-12));
}

TEST_CASE("A speed of the upper surface that is given holds in all rows, and the lower one has the slip beside it",
          "[temperature]") {
    const Values slips{-0.5, -0.2, 0.2, 3.0};
    TemperatureRequest request = rows_that_slip(slips);
    request.chi = GENERATE(0.0, std::numbers::pi);
    if (request.chi > 0)
        for (double& slip : request.slip_x) slip *= -1;
    for (double& traction : request.traction_x) traction *= request.chi > 0 ? -1 : 1;
    request.upper_speed = 0.7 * velocity;
    const SurfaceTemperatures answer = found(request);
    double into_upper = 0;
    for (std::size_t row = 0; row < slips.size(); ++row) {
        const double upper = std::sqrt(0.7 * velocity), lower = std::sqrt((0.7 + slips[row]) * velocity);
        const double right = 2 * heat * std::sqrt(7.75) / (std::sqrt(std::numbers::pi) * steel * (upper + lower));
        CHECK_THAT(answer.upper_temperature[row * nx + (request.chi > 0 ? 29 : 14)], WithinRel(right, 1e-8));
        into_upper += heat * 8 * upper / (upper + lower);
    }
    CHECK_THAT(answer.temperature.heat_upper, WithinRel(into_upper, 1e-8));
    CHECK_FALSE(says(answer, "opposite"));
}

TEST_CASE("The speed of the upper surface that is taken without one gives the same when it is given", "[temperature]") {
    const double w = GENERATE(0.04, 1.0, -1.5);
    TemperatureRequest request = rows_that_slip({w});
    const SurfaceTemperatures without = found(request);
    request.upper_speed = velocity * (1 - w / 2);
    const SurfaceTemperatures with = found(request);
    for (std::size_t i = 0; i < with.upper_temperature.size(); ++i)
        CHECK_THAT(with.upper_temperature[i], WithinRel(without.upper_temperature[i], 1e-12));
    CHECK_THAT(with.temperature.heat_upper, WithinRel(without.temperature.heat_upper, 1e-12));
    CHECK_THAT(with.temperature.peclet, WithinRel(without.temperature.peclet, 1e-12));
}

TEST_CASE("A speed of the upper surface that is none is refused, and one below the slip is warned of",
          "[temperature]") {
    TemperatureRequest request = rows_that_slip({-0.5});
    request.upper_speed = -1;
    Observer none;
    try {
        surface_temperature(request, none);
        FAIL();
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "upper_speed");
    }
    request.upper_speed = 0.4 * velocity;
    CHECK(says(found(request), "opposite"));
}

TEST_CASE("Surfaces that pass in opposite directions are warned of", "[temperature]") {
    CHECK(says(found(rows_that_slip({2.5})), "opposite"));
    CHECK_FALSE(says(found(rows_that_slip({1.9})), "opposite"));
}

TEST_CASE("The largest temperature of each body is that of all its elements", "[temperature]") {
    TemperatureRequest request = rows_that_slip({0});
    request.temperature = {body_of(steel, 0), body_of(steel, 150)};
    const SurfaceTemperatures answer = found(request);
    CHECK_THAT(answer.temperature.largest, WithinRel(75, 1e-12));        // in contact
    CHECK_THAT(answer.temperature.largest_upper, WithinRel(75, 1e-12));  // there, too
    CHECK(answer.temperature.largest_lower == 150);                      // ahead of it
}

TEST_CASE("A layer that flows heats the surfaces by its share of the plastic work", "[temperature]") {
    const TemperatureRequest slips = rows_that_slip({0.05});
    TemperatureRequest flows = slips;
    flows.flow_x = flows.slip_x;
    for (double& flow : flows.flow_x) flow *= -1;  // along the tractions
    flows.flow_y = flows.slip_x = Values(flows.grid.size());
    flows.temperature.plastic_share = GENERATE(1.0, 0.9, 0.0);
    const SurfaceTemperatures by_slip = found(slips), by_flow = found(flows);
    CHECK_THAT(by_flow.temperature.rise, WithinAbs(flows.temperature.plastic_share * by_slip.temperature.rise, 1e-9));
    CHECK_THAT(by_flow.temperature.heat_upper,
               WithinAbs(flows.temperature.plastic_share * by_slip.temperature.heat_upper, 1e-6));
    CHECK(by_flow.temperature.peclet == by_slip.temperature.peclet);
}

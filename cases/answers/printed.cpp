#include "printed.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "answers/contact_solver.hpp"
#include "answers/element_fields.hpp"
#include "answers/element_values.hpp"
#include "answers/rail_patch.hpp"
#include "contactd/subsurface.hpp"
#include "geometry/placement/vector3.hpp"
#include "given/given.hpp"
#include "given/given_friction.hpp"
#include "problem/area.hpp"

namespace contactd::cases {
namespace {

constexpr double joule = 1e-3;  // N mm per J, and N mm/s per W

std::vector<double> or_zeros(std::vector<double> values, std::size_t count) {
    if (values.empty()) values.resize(count);
    return values;
}

/// Returns the displacements of the surfaces of both bodies under the tractions of a simplified theory, which has none
/// of its own.
Displacements surface_displacements(const Solved& solved) {
    const Grid& grid = solved.problem.grid;
    const ContactSolution& solution = solved.solution;
    const MaterialPair bodies = solved.problem.bodies.materials();
    Observer observer;
    StressBlock surface{{}, {}, {0}};
    for (int i = 0; i < grid.nx; ++i) surface.x.push_back(grid.x(i));
    for (int i = 0; i < grid.ny; ++i) surface.y.push_back(grid.y(i));
    Displacements all{std::vector<double>(grid.size()), std::vector<double>(grid.size()),
                      std::vector<double>(grid.size())};
    for (const ContactBody body : {ContactBody::upper, ContactBody::lower}) {
        const bool is_upper = body == ContactBody::upper;
        const SubsurfaceDisplacement moved = subsurface_displacement(
            grid, tractions_on(body, solution.pressure, solution.traction_x, solution.traction_y),
            is_upper ? bodies.upper : bodies.lower, surface, observer);
        const double sign = is_upper ? 1 : -1;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            all.x[i] += sign * moved.x[i];
            all.y[i] += sign * moved.y[i];
            all.z[i] -= moved.z[i];  // along z of the upper body's own frame, and away from the lower one
        }
    }
    return all;
}

Displacements displacements_of(const Solved& solved, bool on_rails) {
    const ContactSolution& solution = solved.solution;
    if (!solution.displacement_x.empty() || on_rails || solved.problem.model == Model::full)
        return {solution.displacement_x, solution.displacement_y, solution.displacement_z};
    return surface_displacements(solved);
}

ByName<std::vector<double>> arrays_of(const Solved& solved, bool on_rails) {
    const ContactSolution& solution = solved.solution;
    const std::size_t count = solved.problem.grid.size();
    ByName<std::vector<double>> arrays;
    const auto put = [&](const char* name, std::vector<double> values) {
        arrays.emplace(name, or_zeros(std::move(values), count));
    };
    std::vector<double> division(count);
    std::ranges::transform(solution.element_division, division.begin(),
                           [](ElementState state) { return static_cast<double>(state); });
    put("IGS", std::move(division));
    put("H", distance_of(solved));
    put("MU", friction_of(solved));
    put("PN", solution.pressure);
    put("PX", solution.traction_x);
    put("PY", solution.traction_y);
    Displacements moved = displacements_of(solved, on_rails);
    put("UX", std::move(moved.x));
    put("UY", std::move(moved.y));
    put("UN", std::move(moved.z));
    put("SX", solution.slip_x);
    put("SY", solution.slip_y);
    RigidSlip rigid = rigid_slip_of(solved);
    put("WX", std::move(rigid.x));
    put("WY", std::move(rigid.y));
    if (!solution.flow_x.empty()) {
        put("TAUCRT", yield_stress(solved.problem, solution));
        put("UPLSX", solved.plastic.x);
        put("UPLSY", solved.plastic.y);
    }
    if (!solution.upper_temperature.empty()) {
        put("TEMP1", solution.upper_temperature);
        put("TEMP2", solution.lower_temperature);
    }
    return arrays;
}

double count_of(const ContactSolution& solution, ElementState state) {
    return static_cast<double>(std::ranges::count(solution.element_division, state));
}

/// Returns numbers that contacts of both modules have.
ByName<double> common_numbers(const Solved& solved) {
    const ContactSolution& solution = solved.solution;
    const double adhesion = count_of(solution, ElementState::adhesion), slip = count_of(solution, ElementState::slip);
    const double plastic = count_of(solution, ElementState::flow);
    const double lost = solution.frictional_power.value_or(solution.frictional_work.value_or(0));
    ByName<double> numbers{{"FN", solution.forces.Fn},
                           {"ELAST.EN.", solution.elastic_energy.value_or(0) * joule},
                           {"FRIC", 0 - lost * joule},
                           {"APPROACH", solution.approach},
                           {"PMAX", solution.pmax},
                           {"NPOT", static_cast<double>(solved.problem.grid.size())},
                           {"NCON", adhesion + slip + plastic},
                           {"NADH", adhesion},
                           {"NSLIP", slip}};
    if (!solution.flow_x.empty()) numbers["NPLAST"] = plastic;
    if (solution.temperature) numbers["MAX(T1,T2)"] = solution.temperature->largest;
    return numbers;
}

struct Pair {
    double x = 0, y = 0;
};

/// Returns creepages or shifts at the centre of spin.
Pair motion_at_spin_centre(const Solved& solved) {
    if (!solved.solution.motion) return {};
    const auto at_centre = [&](double x, double y, double phi) {
        return Pair{x - phi * solved.spin_y, y + phi * solved.spin_x};
    };
    if (const auto* rolling = std::get_if<Rolling>(&*solved.solution.motion))
        return at_centre(rolling->xi, rolling->eta, rolling->phi);
    const auto& shift = std::get<Shift>(*solved.solution.motion);
    return at_centre(shift.rigid_shift.x, shift.rigid_shift.y, shift.rotation);
}

double largest_of(const std::vector<double>& values) {
    return values.empty() ? 0 : std::ranges::max(values);
}

/// Returns the reference of a patch in the axes of the wheel's profile.
geometry::Vector3 on_wheel(const WheelRailState& state, const ProfileFrame& frame, const ContactReference& reference) {
    using geometry::Rotation;
    const Rotation axes = Rotation::yaw_then_roll(state.position.yaw, state.position.roll) *
                          Rotation::yaw_then_roll(state.wheel.yaw, state.wheel.roll);
    return axes.rotated_back({reference.x - frame.x, reference.y - frame.y, reference.z - frame.z});
}

geometry::Vector3 on_rail(const ProfileFrame& frame, const ContactReference& reference) {
    return geometry::Rotation::roll(frame.roll)
        .rotated_back({reference.x - frame.x, reference.y - frame.y, reference.z - frame.z});
}

std::vector<double> coefficients_at_rest(const WheelRailSetup& setup, const ContactPlace& place) {
    if (!setup.friction) return {0};
    const double side = setup.side == Side::left ? -1 : 1;
    const auto at = [&](double angle) { return coefficient_at(setup.friction->mu, side * angle); };
    if (place.rows.empty()) return {at(place.reference.angle)};
    std::vector<double> mu;
    for (const ContactRow& row : place.rows) mu.push_back(at(row.angle));
    return mu;
}

}  // namespace

ContactFilePatch printed_contact(const ContactCase& read, const Given& given, const Solved& solved) {
    const ContactSolution& solution = solved.solution;
    ContactFilePatch patch;
    patch.grid = solved.problem.grid;
    patch.numbers = common_numbers(solved);
    patch.numbers["PMAX"] = largest_of(solution.pressure);
    const bool by_row = given.friction && given.friction->method / 10 == varies::by_row;
    const double unit = by_row || !given.friction ? 1 : given.friction->law.mu[0];
    const double eps = std::get<double>(read.values.at("EPS"));
    const auto rounded = [](double value, double least) { return std::abs(value) < least ? 0 : value; };
    const double least_force = eps * solution.forces.Fn * unit / 2;
    patch.numbers["FX"] = rounded(solution.forces.Fx, least_force);
    patch.numbers["FY"] = rounded(solution.forces.Fy, least_force);
    patch.numbers["MZ"] = rounded(solution.forces.Mz, least_force);
    const Pair motion = motion_at_spin_centre(solved);
    const double least_motion = eps * std::max(std::abs(motion.x), std::abs(motion.y));
    const std::string kind = read.digits.at("T") >= 2 ? "CREEP " : "SHIFT ";
    if (given.digits.force >= 1) patch.numbers[kind + "X"] = rounded(motion.x, least_motion);
    if (given.digits.force == 2) patch.numbers[kind + "Y"] = rounded(motion.y, least_motion);
    if (std::holds_alternative<HertzArea>(given.area)) {
        const HertzResult hertz = hertz_of(given);
        const ByName<double> ellipse{{"A1", hertz.a1}, {"B1", hertz.b1}, {"AA", hertz.axes.a}, {"BB", hertz.axes.b}};
        patch.numbers.insert(ellipse.begin(), ellipse.end());
    }
    patch.numbers["SPINXO"] = given.spin_x;
    patch.numbers["SPINYO"] = given.spin_y;
    patch.mu = {unit};
    patch.friction_bound = solved.problem.friction ? largest_of(solved.problem.friction->mu) * solution.forces.Fn : 0;
    patch.arrays = arrays_of(solved, false);
    return patch;
}

ContactFilePatch printed_patch(const WheelRailPatch& found, const WheelRailSetup& setup, const WheelRailState& state,
                               const WheelRailSolution& solution, const Solved& solved) {
    const ContactPlace& place = found.place;
    const ContactReference& reference = place.reference;
    const Creepages& motion = place.creepages;
    const Forces& forces = solved.solution.forces;
    ContactFilePatch patch;
    patch.grid = place.grid;
    patch.numbers = common_numbers(solved);
    const std::string bar = place.rows.empty() ? "" : "BAR_";
    if (!bar.empty()) patch.numbers.erase("FN");
    const geometry::Vector3 wheel = on_wheel(state, solution.wheel_frame, reference);
    const geometry::Vector3 rail = on_rail(solution.rail_frame, reference);
    const RailPlace counted = counted_from(place, state);
    const ByName<double> more{
        {"XCP(TR)", reference.x},  {"YCP(TR)", reference.y},  {"ZCP(TR)", reference.z}, {"DELTCP(TR)", reference.angle},
        {"CKSI", motion.xi},       {"CETA", motion.eta},      {"CPHI", motion.phi},     {bar + "FN", forces.Fn},
        {bar + "FX", forces.Fx},   {bar + "FS", forces.Fy},   {"MN", forces.Mz},        {"YCP(R)", rail.y},
        {"ZCP(R)", rail.z},        {"XCP(W)", wheel.x},       {"YCP(W)", wheel.y},      {"ZCP(W)", wheel.z},
        {"SPINXO", counted.along}, {"SPINYO", counted.across}};
    patch.numbers.insert(more.begin(), more.end());
    patch.mu = coefficients_at_rest(setup, place);
    const double side = setup.side == Side::left ? -1 : 1;
    if (setup.friction)
        patch.friction_bound = coefficient_at(setup.friction->mu, side * reference.angle) * found.solution.forces.Fn;
    patch.arrays = arrays_of(solved, true);
    return patch;
}

ByName<double> printed_forces(const WheelRailState& state, const WheelRailSolution& solution) {
    const Wrench &track = solution.forces.track, &wheelset = solution.forces.wheelset;
    ByName<double> numbers{{"FX(TR)", track.Fx},    {"FY(TR)", track.Fy},    {"FZ(TR)", track.Fz},
                           {"FX(WS)", wheelset.Fx}, {"FY(WS)", wheelset.Fy}, {"FZ(WS)", wheelset.Fz}};
    if (state.Fz) numbers["Z_WS"] = solution.z;
    if (state.Fx) numbers["VPITCH_WS"] = solution.pitch_rate;
    return numbers;
}

}  // namespace contactd::cases

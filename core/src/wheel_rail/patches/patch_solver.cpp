#include "patch_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"
#include "fatigue/contact_fatigue.hpp"
#include "types/fatigue/contact_fatigue_check.hpp"
#include "wear/contact_wear.hpp"

namespace contactd {
namespace {

using geometry::CandidatePatch;
using geometry::spin_offset;
using Values = std::vector<double>;

/// Returns the inclination of the rail at each row of elements.
Values row_angles(const ContactPlace& place, const geometry::RailSurface& rail) {
    Values angles;
    for (const ContactRow& row : place.rows) angles.push_back(row.angle);
    if (!angles.empty()) return angles;
    double s = 0.5 * (rail.visible().from + rail.visible().to);
    for (int iy = 0; iy < place.grid.ny; ++iy) {
        const double y = place.reference.y + place.grid.y(iy) * std::cos(place.reference.angle);
        rail.find_y(std::clamp(y, rail.visible().low, rail.visible().high), s);
        const ProfilePoint slope = rail.place(s).slope;
        angles.push_back(std::atan2(slope.z, slope.y));
    }
    return angles;
}

FrictionLaw friction_law(const WheelRailFriction& friction, const ContactPlace& place,
                         const geometry::RailSurface& rail) {
    FrictionLaw law{{}, friction.kinetic, friction.layer, friction.temperature};
    const auto& by_angle = friction.temperature_by_angle;
    if (!friction.along_profile || (friction.mu.size() == 1 && by_angle.size() <= 1)) {
        law.mu = {coefficient_at(friction.mu, place.reference.angle)};
        if (!by_angle.empty()) law.temperature = temperature_friction_at(friction, place.reference.angle);
        return law;
    }
    for (const double angle : row_angles(place, rail)) {
        law.mu.insert(law.mu.end(), static_cast<std::size_t>(place.grid.nx), coefficient_at(friction.mu, angle));
        if (!by_angle.empty()) law.temperature_of_rows.push_back(temperature_friction_at(friction, angle));
    }
    return law;
}

Rolling rolling_of(const Creepages& creepages, const WheelRailState& state, double dq) {
    Rolling rolling;
    rolling.xi = creepages.xi;
    rolling.eta = creepages.eta;
    rolling.phi = creepages.phi;
    rolling.chi = creepages.chi;
    rolling.velocity = creepages.velocity;
    rolling.dq = dq;
    rolling.spin_offset = spin_offset;
    if (state.motion == WheelRailMotion::transient_rolling) {
        rolling.kind = RollingKind::transient;
        if (state.time_step) rolling.dq = creepages.velocity * *state.time_step;
    }
    return rolling;
}

/// Returns the shift, in which nothing slips if the wheel does not move.
Shift shift_of(const Creepages& creepages, double seconds) {
    const double length = creepages.velocity * seconds;
    Shift shift;
    shift.rigid_shift = {length * creepages.xi, length * creepages.eta};
    shift.rotation = length * creepages.phi;
    shift.duration = seconds;
    return shift;
}

RigidSlip rigid_slip_of(const std::vector<geometry::RowSlip>& rows, const Grid& grid, double ahead) {
    RigidSlip slip;
    for (const geometry::RowSlip& row : rows)
        for (int ix = 0; ix < grid.nx; ++ix) {
            slip.x.push_back(row.along);
            slip.y.push_back(row.across + row.spin * (grid.x(ix) + ahead));
        }
    return slip;
}

/// Returns the range of row middles between two positions across the track, as ends of y on the grid.
Extent rows_between(const ContactPlace& place, double from, double to) {
    const Grid& grid = place.grid;
    Extent rows{0, -1};
    for (int iy = 0; iy < grid.ny; ++iy) {
        const double y = place.rows.empty() ? place.reference.y + std::cos(place.reference.angle) * grid.y(iy)
                                            : place.rows[static_cast<std::size_t>(iy)].y;
        if (y < from || y > to) continue;
        if (rows.to < rows.from) rows.from = grid.y(iy) - 0.25 * grid.dy;
        rows.to = grid.y(iy) + 0.25 * grid.dy;
    }
    return rows;
}

/// Returns whether the spin moves no element by more than a rounding error of creepages.
bool is_next_to_nothing(double phi, const Grid& grid) {
    constexpr double least_creepage = 1e-9;
    return std::abs(phi) * std::hypot(grid.nx * grid.dx, grid.ny * grid.dy) <= least_creepage;
}

/// Refuses the contact problem of a patch with the names of the set-up from which it was made.
[[noreturn]] void refuse_as_of_wheel(const InvalidArgument& error, const ContactProblem& problem) {
    const std::string& field = error.field();
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (field == "friction.rolling.phi" && problem.model == Model::hertz)
        throw InvalidArgument("model",
                              "is hertz, whose closed form of friction does not support spin, which occurs in nearly "
                              "every position of a wheel; use fastsim or full, or no friction (friction null)");
    if (field == "friction.rolling.dq" || field == "shift_x" || field == "shift_y")
        throw InvalidArgument(rolling && rolling->dq == problem.grid.dx ? "dx" : "dq",
                              "as the step of rolling " + error.problem());
    if (field == "friction.duration" || field.starts_with("friction.rigid_shift") || field == "friction.rotation")
        throw InvalidArgument("state.time_step", "results in a shift whose " + field + " " + error.problem());
    if (field == "friction.rolling.velocity")
        throw InvalidArgument("state.velocity", "results in a velocity of rolling that " + error.problem());
    if (field == "derivatives" || field == "displacements") throw InvalidArgument("state." + field, error.problem());
    throw;
}

void scale(RigidSlip& slip, double length) {
    for (auto* values : {&slip.x, &slip.y})
        for (double& value : *values) value *= length;
}

/// Sets the motion, and the additional slip of each element, which is the whole slip if surfaces slip row by row.
void set_motion(ContactProblem& problem, const WheelRailSetup& setup, const WheelRailState& state,
                const CandidatePatch& found) {
    Creepages creepages = found.place.creepages;
    if (!found.row_slips.empty()) creepages.xi = creepages.eta = creepages.phi = 0;
    problem.motion = motion_of(creepages, problem.grid.dx, setup, state);
    auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling != nullptr && rolling->steady()) problem.upper_speed = found.rail_speed;
    if (rolling != nullptr && setup.model == Model::hertz && is_next_to_nothing(rolling->phi, problem.grid))
        rolling->phi = 0;
    if (!found.row_slips.empty())
        problem.rigid_slip = rigid_slip_of(found.row_slips, problem.grid,
                                           rolling ? spin_offset * rolling->dq * std::cos(rolling->chi) : 0);
    if (!found.additional_slip.empty()) problem.rigid_slip = found.additional_slip;
    if (rolling == nullptr) scale(problem.rigid_slip, creepages.velocity * std::get<Shift>(problem.motion).duration);
}

/// Returns rows in track coordinates, and the creepages of the reference, even if surfaces slip row by row.
WearPlace wear_place(const ContactPlace& place) {
    WearPlace result{.xi = place.creepages.xi, .eta = place.creepages.eta};
    for (const ContactRow& row : place.rows) result.rows.push_back({.y = row.y, .z = row.z, .angle = row.angle});
    if (!place.rows.empty()) return result;
    const auto& [x, y, z, angle] = place.reference;
    for (int iy = 0; iy < place.grid.ny; ++iy) {
        const double across = place.grid.y(iy);
        result.rows.push_back({.y = y + across * std::cos(angle), .z = z + across * std::sin(angle), .angle = angle});
    }
    return result;
}

ContactSolution solve_on(ContactProblem& problem, const ContactPlace& place, const PatchStrips& strips,
                         const PatchRules& rules, const InfluenceSource& influences, Observer& observer) {
    if (problem.model != Model::full) return solve_contact(problem, {}, observer);
    const ContactInfluence influence = influences(problem, strips, observer);
    if (problem.normal_model == NormalModel::of_model) problem.regions = contact_regions(place, rules);
    return solve_contact(problem, influence, observer);
}

}  // namespace

std::optional<ContactRegions> contact_regions(const ContactPlace& place, const PatchRules& rules) {
    const double wider = 0.4 * rules.distance_combine, wider_across = wider * std::cos(place.reference.angle);
    const std::size_t count = place.regions.size();
    if (count < 2) return std::nullopt;
    ContactRegions result;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i) {
        const OverlapRegion& region = place.regions[i];
        const Extent y = rows_between(place, region.y.from - wider_across, region.y.to + wider_across);
        if (y.to < y.from) continue;
        kept.push_back(i);
        const double origin = place.reference.x;
        result.limits.push_back({{region.x.from - wider - origin, region.x.to + wider - origin}, y});
    }
    for (const std::size_t i : kept)
        for (const std::size_t j : kept)  // Both shares of a pair may differ by rounding errors.
            result.shares.push_back(place.shares[std::min(i, j) * count + std::max(i, j)]);
    if (kept.empty()) return std::nullopt;
    return result;
}

Motion motion_of(const Creepages& creepages, double dx, const WheelRailSetup& setup, const WheelRailState& state) {
    if (state.motion == WheelRailMotion::shift || !(creepages.velocity > 0))
        return shift_of(creepages, state.time_step.value_or(1));
    return rolling_of(creepages, state, step_of_rolling(setup, dx));
}

ContactProblem problem_of(const WheelRailSetup& setup, const WheelRailState& state, const CandidatePatch& found,
                          const geometry::RailSurface& rail) {
    ContactProblem problem;
    problem.grid = found.place.grid;
    problem.bodies = setup.bodies;
    problem.model = setup.model;
    problem.normal_model = setup.normal_model;
    problem.simplified = setup.simplified;
    problem.sheet_flexibility = setup.sheet_flexibility;
    problem.settings = setup.settings;
    if (has_distances(setup))
        problem.gap = found.gap;
    else
        problem.gap = found.paraboloid;
    problem.approach = found.place.approach;
    const bool is_steady = state.motion == WheelRailMotion::steady_rolling;
    if (!setup.friction || (is_steady && !(found.place.creepages.velocity > 0))) return problem;
    problem.friction = friction_law(*setup.friction, found.place, rail);
    problem.temperature = setup.temperature;
    problem.wear = setup.wear;
    set_motion(problem, setup, state, found);
    return problem;
}

ContactSolution solve_patch(ContactProblem problem, const ContactPlace& place, const PatchStrips& strips,
                            const PatchRules& rules, const InfluenceSource& influences, Observer& observer) {
    try {
        const std::optional<WearRequest> wear = std::exchange(problem.wear, std::nullopt);
        ContactSolution solution = solve_on(problem, place, strips, rules, influences, observer);
        if (wear && solution.motion) solution.wear = contact_wear(*wear, problem, wear_place(place), solution);
        return solution;
    } catch (const InvalidArgument& error) {
        refuse_as_of_wheel(error, problem);
    }
}

void add_fatigue(const WheelRailSetup& setup, const ContactPlace& place, ContactSolution& solution,
                 Observer& observer) {
    if (!setup.fatigue || !solution.motion || !std::holds_alternative<Rolling>(*solution.motion)) return;
    ContactProblem problem;
    problem.grid = place.grid;
    problem.bodies = setup.bodies;
    problem.model = setup.model;
    problem.fatigue = setup.fatigue;
    check_fatigue(problem, false);
    FatiguePlace of_rows{.wear = wear_place(place)};
    for (const ContactRow& row : place.rows) of_rows.angles.push_back(row.angle);
    solution.fatigue = contact_fatigue(problem, of_rows, solution, observer);
}

}  // namespace contactd

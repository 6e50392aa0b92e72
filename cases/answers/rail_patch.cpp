#include "rail_patch.hpp"

#include <cmath>
#include <utility>

#include "wheel_rail/mirror.hpp"
#include "wheel_rail/patches/patch_solver.hpp"

namespace contactd::cases {
namespace {

std::optional<FrictionLaw> friction_of(const WheelRailSetup& setup, const ContactPlace& place) {
    if (!setup.friction) return {};
    const double side = setup.side == Side::left ? -1 : 1;
    FrictionLaw law{{}, setup.friction->kinetic, setup.friction->layer, setup.friction->temperature};
    const auto& mu = setup.friction->mu;
    const auto& heated = setup.friction->temperature_by_angle;
    if (!setup.friction->along_profile || mu.size() == 1 || place.rows.empty()) {
        law.mu = {coefficient_at(mu, side * place.reference.angle)};
        if (!heated.empty()) law.temperature = temperature_friction_at(*setup.friction, side * place.reference.angle);
        return law;
    }
    for (const ContactRow& row : place.rows) {
        law.mu.insert(law.mu.end(), static_cast<std::size_t>(place.grid.nx), coefficient_at(mu, side * row.angle));
        if (!heated.empty())
            law.temperature_of_rows.push_back(temperature_friction_at(*setup.friction, side * row.angle));
    }
    return law;
}

/// Returns the forces of a curved contact: the vector sums over all rows, in the axes of the reference.
Forces of_rows(const WheelRailPatch& patch) {
    const Wrench& track = patch.forces.track;
    const ContactReference& at = patch.place.reference;
    const double c = std::cos(at.angle), s = std::sin(at.angle);
    const double my = track.My - (at.z * track.Fx - at.x * track.Fz),
                 mz = track.Mz - (at.x * track.Fy - at.y * track.Fx);
    return {track.Fz * c - track.Fy * s, track.Fx, track.Fy * c + track.Fz * s, mz * c - my * s};
}

void move(ContactRegions& regions, const RailPlace& by) {
    for (auto& [x, y] : regions.limits) {
        x = {x.from + by.along, x.to + by.along};
        y = {y.from + by.across, y.to + by.across};
    }
}

/// Converts the motion of the reference to that of the origin of elements.
Motion seen_from(Motion motion, const RailPlace& counted) {
    if (auto* rolling = std::get_if<Rolling>(&motion)) {
        rolling->xi += rolling->phi * counted.across;
        rolling->eta -= rolling->phi * counted.along;
    } else {
        auto& shift = std::get<Shift>(motion);
        shift.rigid_shift.x += shift.rotation * counted.across;
        shift.rigid_shift.y -= shift.rotation * counted.along;
    }
    return motion;
}

/// Returns the regions of the contact problem. They are computed for a right wheel, and mirrored for a left one.
std::optional<ContactRegions> regions_of(const WheelRailSetup& setup, ContactPlace place) {
    if (setup.normal_model != NormalModel::of_model) return std::nullopt;
    if (setup.side == Side::left) mirror(place);
    std::optional<ContactRegions> regions = contact_regions(place, setup.patches);
    if (regions && setup.side == Side::left) mirror(*regions);
    return regions;
}

/// Returns the name of a feature that the contact problem of a patch lacks, or null if it is complete.
const char* left_out(const WheelRailSetup& setup, const WheelRailState& state, const ContactPlace& place) {
    if (setup.model != Model::full) return "a simplified model";
    if (setup.normal_model != NormalModel::of_model) return "virtual penetration";
    if (state.motion != WheelRailMotion::steady_rolling) return "a motion that is not steady";
    if (!place.rows.empty()) return "a curved contact";
    if (setup.rigid_slip != RigidSlipKind::plane) return "slip of the surfaces";
    if (setup.friction && setup.friction->layer) return "an interfacial layer";
    return nullptr;
}

}  // namespace

RailPlace counted_from(const ContactPlace& place, const WheelRailState& state) {
    if (state.motion == WheelRailMotion::steady_rolling) return {};
    const bool moves = state.motion == WheelRailMotion::transient_rolling;
    return {place.on_rail.along - (moves ? state.position.x : 0), place.on_rail.across};
}

Motion show_patch(const WheelRailPatch& patch, const WheelRailSetup& setup, const WheelRailState& state,
                  Solved& solved) {
    const ContactPlace& place = patch.place;
    const Motion motion = motion_of(place.creepages, place.grid.dx, setup, state);
    solved.problem = {};
    solved.solution = patch.solution;
    solved.sensitivities.reset();
    solved.beyond = left_out(setup, state, place);
    solved.problem.grid = place.grid;
    solved.problem.gap = patch.gap;
    solved.problem.regions = regions_of(setup, place);
    solved.problem.bodies = setup.bodies;
    solved.problem.settings = setup.settings;
    solved.problem.sheet_flexibility = setup.sheet_flexibility;
    solved.problem.friction = friction_of(setup, place);
    const RailPlace counted = counted_from(place, state);
    solved.problem.motion = seen_from(motion, counted);
    solved.problem.approach = patch.solution.approach;
    solved.solution.motion = solved.problem.motion;
    take_elements(solved.problem, solved.solution, setup.friction && place.creepages.velocity > 0);
    solved.plastic = plastic_slip(solved.problem, solved.solution, {});
    Forces& forces = solved.solution.forces;
    if (!place.rows.empty()) forces = of_rows(patch);
    // Across the rail, moments of the rows of a curved contact are about its reference.
    forces.Mz += counted.along * forces.Fy - (place.rows.empty() ? counted.across * forces.Fx : 0);
    solved.problem.grid.x0 += counted.along;
    solved.problem.grid.y0 += counted.across;
    if (solved.problem.regions) move(*solved.problem.regions, counted);
    return motion;
}

}  // namespace contactd::cases

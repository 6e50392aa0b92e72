#include "wheel_rail/warnings.hpp"

#include <cmath>

#include "types/number_text.hpp"
#include "wheel_rail/units.hpp"

namespace contactd {
namespace {

constexpr double largest_slide = 0.5;       // longitudinal creepage of a wheel that is not meant to slide
constexpr double largest_curvature = 0.05;  // ratio of the rail's curvature along the track to the wheel's

}  // namespace

std::string name_of(const ContactReference& reference, Side side) {
    return "The contact at y = " + short_text(side == Side::left ? -reference.y : reference.y) + " mm";
}

std::string apart_along_normal(const ContactReference& reference, Side side) {
    return name_of(reference, side) +
           " is neglected: wheel and rail overlap when seen from above, but not along the normal of any element of its "
           "plane. Extend the profiles if they end there, or check position.z.";
}

std::vector<std::string> warnings_of(const geometry::CandidatePatch& found, const WheelRailSetup& setup,
                                     const WheelRailState& state, bool has_friction) {
    std::vector<std::string> warnings;
    const std::string name = name_of(found.place.reference, setup.side);
    if (found.quality.bend > most_bend)
        warnings.push_back(
            name + " is too strongly curved for a planar contact: the rail's surface turns by up to " +
            short_text(found.quality.bend) +
            " rad from the plane of the contact. Set conformal to rotated, or to auto, which chooses it.");
    if (found.place.grid.dx > setup.dx || found.place.grid.dy > setup.dy)
        warnings.push_back(name + " has elements of " + short_text(found.place.grid.dx) + " by " +
                           short_text(found.place.grid.dy) +
                           " mm, larger than dx and dy, to limit it to patches.max_elements = " +
                           std::to_string(setup.patches.max_elements) + ".");
    if (found.quality.at_end)
        warnings.push_back(name +
                           " reaches the end of a profile. The surface beyond is unknown, and the solution neglects "
                           "any contact there.");
    if (found.quality.curvature > largest_curvature)
        warnings.push_back(
            name + " lies where the curvature of the rail along the track is " +
            short_text(100 * found.quality.curvature) +
            " % of that of the wheel, which the search along the locus neglects. Set patches.search to mesh.");
    if (has_friction && !(found.place.creepages.velocity > 0))
        warnings.push_back(
            name + " does not roll: without a velocity there are no creepages, so it is solved without friction.");
    if (has_friction && std::abs(found.place.creepages.xi) > largest_slide)
        warnings.push_back(name + " slides along the rail by " + short_text(std::abs(found.place.creepages.xi)) +
                           " of the rolling velocity. For a rolling wheel, velocity.pitch is close to "
                           "-velocity.x/nominal_radius, in rad/s, mm/s and mm." +
                           unit_of_speed(setup, state));
    return warnings;
}

std::vector<std::string> warnings_of(const std::optional<geometry::PassedOver>& place, Side side) {
    if (!place) return {};
    return {
        "At x = " + short_text(place->x) + " and y = " + short_text(side == Side::left ? -place->y : place->y) +
        " mm the rail reaches " + short_text(place->depth) +
        " mm into the wheel, at an edge or a step that the search along the locus misses. Set patches.search to mesh."};
}

std::vector<std::string> warnings_of(const ContactReference& reference, Side side, const ContactSolution& solution) {
    std::vector<std::string> warnings;
    for (const std::string& warning : solution.warnings)
        if (!names_inputs_of_patches(warning)) warnings.push_back(name_of(reference, side) + ": " + warning);
    return warnings;
}

}  // namespace contactd

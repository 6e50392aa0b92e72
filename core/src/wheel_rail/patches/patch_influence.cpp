#include "contactd/patch_influence.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bodies/rotated_displacement_influence.hpp"
#include "bodies/strip_influence.hpp"
#include "contactd/strip_spectrum.hpp"
#include "wheel_rail/patches/curved_size.hpp"

namespace contactd {
namespace {

StripSpectrum part_of(const StripSpectrum& whole, int first, int strips) {
    StripSpectrum part = whole;
    part.strips = strips;
    part.frames.assign(whole.frames.begin() + first, whole.frames.begin() + first + strips);
    part.values.clear();
    part.values.reserve(part.nodes.size() * part.component_size());
    for (std::size_t node = 0; node < part.nodes.size(); ++node)
        for (int a = 0; a < 3 * strips; ++a)
            for (int b = 0; b <= a; ++b)
                part.values.push_back(whole.values[whole.index(node, 3 * first + a, 3 * first + b)]);
    return part;
}

/// Returns strips in the numbering of the section. Only the required part of the finite elements' transform is
/// converted to a table.
StripTable table_of(const std::optional<BodyStrips>& strips, const Grid& grid, const IcRecord* record,
                    const Observer& observer) {
    if (!strips) return {grid.nx, grid.ny};
    if (!std::holds_alternative<StripSpectrum>(record->tables))
        return cropped(std::get<StripTable>(body_table(*record, strips->spec, 1, observer)), strips->first, grid.ny,
                       grid.nx);
    const StripSpectrum part = part_of(std::get<StripSpectrum>(record->tables), strips->first, grid.ny);
    return strip_table(part, grid.dx / grid.dy, grid.nx, 0, grid.dy / strips->spec.material.G, 1, observer);
}

}  // namespace

ContactInfluence patch_influence(const ContactProblem& problem, const PatchStrips& strips, const IcRecord* of_rail,
                                 const IcRecord* of_wheel, const Observer& observer) {
    const Grid& grid = problem.grid;
    if (strips.along_loaded_row) {
        std::vector<double> angles;
        for (const StripFrame& frame : strips.frames) angles.push_back(frame.angle);
        return rotated_displacement_influence(problem, angles, observer);
    }
    if (!strips.of_sections()) return RotatedPatches().of(problem, strips, observer);
    check_curved_size(grid);
    // A rail's strips run to the right and a wheel's to the left, like those of bodies that lie on each other; rows run
    // to the right.
    StripTable wheel = table_of(strips.wheel, grid, of_wheel, observer);
    return strip_influence(problem, mirrored(pair_of(table_of(strips.rail, grid, of_rail, observer), std::move(wheel))),
                           observer);
}

}  // namespace contactd

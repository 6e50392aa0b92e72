// Returns results of a whole wheel on a rail, and the positions of its patches.
#include <algorithm>
#include <array>

#include "answers/rail_places.hpp"
#include "interface/entry.hpp"
#include "problem/rail_setup.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Copies as many numbers as the caller has room for, and sets the rest to zero.
void fill(std::span<const double> found, std::span<double> out) {
    std::ranges::fill(out, 0);
    std::copy_n(found.begin(), std::min(found.size(), out.size()), out.begin());
}

const WheelRailPatch& patch_of(const RailCase& rail, int icp) {
    const auto patches = ordered_patches(rail);
    if (icp < 1 || static_cast<std::size_t>(icp) > patches.size())
        throw Refused(error_code::handle, "Patch " + std::to_string(icp) + " does not exist; the solution has " +
                                              std::to_string(patches.size()) + ".");
    return *patches[static_cast<std::size_t>(icp) - 1];
}

}  // namespace

extern "C" void cntc_getnumcontactpatches(int* ire, int* npatch) {
    if (npatch != nullptr) *npatch = 0;
    with_rail("cntc_getnumcontactpatches", ire, [&](const RailCase& rail, const Settings&) {
        require(npatch, "npatch");
        *npatch = static_cast<int>(solution_of(rail).patches.size());
    });
}
CONTACTD_FORTRAN_NAME(cntc_getnumcontactpatches)

extern "C" void cntc_getcontactlocation(int* ire, int* icp, int* lenarr, double* values) {
    clear(values, lenarr);
    with_rail("cntc_getcontactlocation", ire, [&](RailCase& rail, const Settings& common) {
        const WheelRailPatch& patch = patch_of(rail, number_of(icp));
        auto found = location_of(patch, outlines_of(rail, common), frames_of(rail, common));
        if (const auto& deflection = rail.solution->rail_deflection) {
            found[17] = deflection->y;
            found[18] = deflection->z;
        }
        constexpr std::array angles{4, 9, 14, 24, 25, 28, 33, 37, 38};
        for (std::size_t i = 0; i < found.size(); ++i)
            if (std::ranges::find(angles, static_cast<int>(i) + 1) == angles.end()) found[i] /= common.units.length;
        fill(found, room(values, lenarr, 1, "values"));
    });
}
CONTACTD_FORTRAN_NAME(cntc_getcontactlocation)

extern "C" void cntc_getglobalforces(int* ire, int* icp, int* lenarr, double* values) {
    clear(values, lenarr);
    with_rail("cntc_getglobalforces", ire, [&](RailCase& rail, const Settings& common) {
        const int patch = number_of(icp);
        const WheelRailSolution& solution = solution_of(rail);
        const WheelRailForces& forces = patch == all_problems ? solution.forces : patch_of(rail, patch).forces;
        auto found = wrenches_of(forces, frames_of(rail, common));
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i] *= common.units.body / (i % 6 < 3 ? 1 : common.units.moment());
        fill(found, room(values, lenarr, 1, "values"));
    });
}
CONTACTD_FORTRAN_NAME(cntc_getglobalforces)

extern "C" void cntc_getwheelsetposition(int* ire, int* lenarr, double* values) {
    clear(values, lenarr);
    with_rail("cntc_getwheelsetposition", ire, [&](const RailCase& rail, const Settings& common) {
        const WheelsetPosition& at = rail.settings.position;
        const double mm = common.units.length, z = rail.current ? rail.solution->z : at.height();
        fill(std::array{at.x / mm, at.y / mm, z / mm, at.roll, at.yaw, at.pitch}, room(values, lenarr, 1, "values"));
    });
}
CONTACTD_FORTRAN_NAME(cntc_getwheelsetposition)

extern "C" void cntc_getwheelsetvelocity(int* ire, int* lenarr, double* values) {
    clear(values, lenarr);
    with_rail("cntc_getwheelsetvelocity", ire, [&](const RailCase& rail, const Settings& common) {
        const WheelsetVelocity& given = rail.settings.velocity;
        const double mm = common.units.length, pitch = rail.current ? rail.solution->pitch_rate : given.pitch;
        const double forwards = on_roller(common) ? 0 : given.x * rail.settings.velocity_length;
        fill(std::array{forwards / mm, given.y / mm, given.z / mm, given.roll, given.yaw, pitch},
             room(values, lenarr, 1, "values"));
    });
}
CONTACTD_FORTRAN_NAME(cntc_getwheelsetvelocity)

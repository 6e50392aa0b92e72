#include "names_in_files.hpp"

#include <map>
#include <string_view>

namespace contactd::cases {
namespace {

using Names = std::map<std::string, const char*, std::less<>>;

const Names names_of_both{{"bodies.upper.nu", "POISS1"},
                          {"bodies.lower.nu", "POISS2"},
                          {"bodies.upper.G", "GG1"},
                          {"bodies.lower.G", "GG2"},
                          {"friction.mu", "FSTAT, FKIN"}};
const Names names_on_rails{{"dx", "DX"},
                           {"dy", "DS"},
                           {"dq", "DQREL"},
                           {"patches.angle_separate", "A_SEP"},
                           {"patches.distance_separate", "D_SEP"},
                           {"patches.distance_combine", "D_COMB"},
                           {"patches.distance_turn", "D_TURN"},
                           {"track.gauge", "GAUGWD"},
                           {"track.gauge_height", "GAUGHT"},
                           {"track.cant", "CANT"},
                           {"track.roller_radius", "NOMRADR"},
                           {"track.springs.y", "KYRAIL"},
                           {"track.springs.z", "KZRAIL"},
                           {"wheelset.nominal_radius", "NOMRADW"},
                           {"wheelset.flange_back_distance", "FBDIST"},
                           {"wheelset.flange_back_position", "FBPOS"},
                           {"rail.file", "RFNAME, MIRRORY, SCALE, SMOOTH"},
                           {"wheel.file", "WFNAME, MIRRORY, SCALE, SMOOTH"},
                           {"rail_slices", "RFNAME"},
                           {"wheel_slices", "WFNAME"},
                           {"Fz", "FZ"},
                           {"position.x", "S"},
                           {"position.y", "Y"},
                           {"position.z", "Z"},
                           {"position.roll", "ROLL"},
                           {"position.yaw", "YAW"},
                           {"position.pitch", "PITCH"},
                           {"velocity.x", "VS"},
                           {"velocity.y", "VY"},
                           {"velocity.z", "VZ"},
                           {"velocity.roll", "VROLL"},
                           {"velocity.yaw", "VYAW"},
                           {"velocity.pitch", "VPITCH"},
                           {"rail.y", "DYRAIL"},
                           {"rail.z", "DZRAIL"},
                           {"rail.roll", "DROLLR"}};
const Names names_alone{{"grid.nx", "MX"},
                        {"grid.ny", "MY"},
                        {"grid.dx", "DX"},
                        {"grid.dy", "DY"},
                        {"Fn", "FN"},
                        {"approach", "PEN"},
                        {"friction.rolling.chi", "CHI"},
                        {"friction.rolling.dq", "DQ"},
                        {"friction.rolling.velocity", "VELOC"},
                        {"friction.rolling.xi", "CKSI"},
                        {"friction.rolling.eta", "CETA"},
                        {"friction.rolling.phi", "CPHI"}};

/// Returns the name of a field or of the object that contains it; null if there is none.
const char* name_of(std::string_view field, const Names& names) {
    while (!field.empty()) {
        if (const auto found = names.find(field); found != names.end()) return found->second;
        const std::size_t dot = field.rfind('.');
        field = dot == std::string_view::npos ? std::string_view() : field.substr(0, dot);
    }
    return nullptr;
}

}  // namespace

std::string in_names_of_files(const InvalidArgument& error, int module) {
    std::string_view field = error.field();
    for (const std::string_view prefix : {"setup.", "state."})
        if (field.starts_with(prefix)) field.remove_prefix(prefix.size());
    const char* name = name_of(field, names_of_both);
    if (name == nullptr) name = name_of(field, module == 1 ? names_on_rails : names_alone);
    return (name != nullptr ? std::string(name) + " (" + error.field() + ")" : error.field()) + " " + error.problem() +
           ".";
}

}  // namespace contactd::cases

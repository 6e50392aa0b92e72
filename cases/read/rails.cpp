// Reads module 1: a wheel on its rail or roller.
#include <array>
#include <string>

#include "steps.hpp"

namespace contactd::contact_files {
namespace {

bool is_on_roller(const Reading& reading) {
    return reading.digit("C1") >= 4;
}

bool has_track(const Reading& reading) {
    return reading.digit("Z") == 1 || reading.digit("Z") == 3;
}

bool has_wheel(const Reading& reading) {
    return reading.digit("E") == 3 || reading.digit("E") == 5;
}

std::string conformal_method(const Reading& reading) {
    return reading.digit("C") == 4 ? "IF_METH# VARIANT#" : "";
}

void read_discretisation(Reading& reading) {
    if (reading.digit("D") < 2) return;
    reading.forget("D_TURN");
    read_group(reading, "DX DS DQREL A_SEP^ D_SEP D_COMB {D_TURN G_MISS=-1}");
    if (!reading.has("D_TURN")) reading.take("D_TURN", 2 * reading.real("D_SEP") - reading.real("D_COMB"));
}

/// Reads the track. The first value determines whether the gauge is measured. On a roller, the cant of an earlier case
/// remains effective.
void read_track(Reading& reading) {
    if (!has_track(reading)) return;
    reading.forget("GAUGSQ GAUGWD RAILY0 RAILZ0 NOMRADR");
    ByName<ContactValue> track = read_values(reading, std::string("GAUGHT GAUGSQ/RAILY0 GAUGWD/RAILZ0 ") +
                                                          (is_on_roller(reading) ? "NOMRADR" : "CANT^") + " {CURV=0}");
    const bool is_measured = std::get<double>(track.at("GAUGHT")) > 0;
    for (const auto& [name, value] : track) {
        const auto slash = name.find('/');
        const bool is_either = slash != name.npos;
        reading.take(!is_either ? name : is_measured ? name.substr(0, slash) : name.substr(slash + 1), value);
    }
}

/// Reads the name and the options of a profile. `of` is RAIL_ or WHEEL_.
void read_profile_options(Reading& reading, const std::string& file, const std::string& of) {
    const auto group = [&](std::string text) {
        for (auto at = text.find('@'); at != text.npos; at = text.find('@')) text.replace(at, 1, of);
        return text;
    };
    read_group(reading, group(file + "' @MIRRORY# @SCALE @SMOOTH {@MIRRORZ#=0 @PRFOPT#=0}"));
    const int options = reading.integer(of + "PRFOPT");
    reading.forget(group("@ERRHND"));
    reading.take(of + "MAXOMIT", 0.5);
    if (options >= 1) {
        read_group(reading, group("@ISMOOTH# @ZIGTHRS^ @KINKHIGH^ @KINKLOW^ @KINKWID"));
    } else {
        reading.take(of + "ISMOOTH", 0);
        for (const auto& [name, word] : {std::pair("ZIGTHRS", "150d"), std::pair("KINKHIGH", "30d"),
                                         std::pair("KINKLOW", "6d"), std::pair("KINKWID", "2")})
            reading.take(of + name, *angle_in(word));
    }
    if (options >= 2) read_group(reading, group("@ERRHND# @MAXOMIT"));
}

void read_rail(Reading& reading) {
    if (reading.digit("Z") == 3) read_profile_options(reading, "RFNAME", "RAIL_");
}

std::string rail_position(const Reading& reading) {
    return reading.digit("Z") >= 2 ? "DYRAIL DZRAIL DROLLR^ VYRAIL VZRAIL VROLLR^" : "";
}

std::string rail_springs(const Reading& reading) {
    return reading.digit("Z") >= 2 && reading.digit("F") == 3 ? "KYRAIL FYRAIL KZRAIL FZRAIL {DYSTEP0=1}" : "";
}

std::string wheelset(const Reading& reading) {
    return has_wheel(reading) ? "FBDIST FBPOS NOMRADW {YTAPE}" : "";
}

void read_wheel(Reading& reading) {
    if (has_wheel(reading)) read_profile_options(reading, "WFNAME", "WHEEL_");
}

std::string wheelset_position(const Reading& reading) {
    if (reading.digit("E") < 1) return {};
    return std::string(is_on_roller(reading) ? "X_WS" : "S_WS") + " Y_WS " + (reading.digit("N") == 0 ? "Z_WS" : "FZ") +
           " ROLL^ YAW^ PITCH^";
}

std::string wheelset_velocity(const Reading& reading) {
    if (reading.digit("E") < 2) return {};
    return std::string(is_on_roller(reading) ? "RPITCH^" : "VS") + " VY VZ VROLL^ VYAW^ " +
           (reading.digit("F") == 1 ? "FX" : "VPITCH^");
}

std::string wheel_position(const Reading& reading) {
    return reading.digit("E") >= 4 ? "DXWHL DYWHL DZWHL DROLLW^ DYAWW^ DPITCHW^" : "";
}

std::string wheel_velocity(const Reading& reading) {
    return reading.digit("E") >= 4 ? "VXWHL VYWHL VZWHL VROLLW^ VYAWW^ VPITCHW^" : "";
}

constexpr std::array steps_of_rails{
    Step{.group = solver_bounds},
    Step{.group = solver_options, .replaces = solver_option_names},
    Step{.read = read_friction},
    Step{.group = conformal_method},
    Step{.group = elastic_constants},
    Step{.group = thin_sheet},
    Step{.group = material_constants},
    Step{.group = damping},
    Step{.group = heat_of_first},
    Step{.group = heat_of_second},
    Step{.group = plastic_heat},
    Step{.read = read_discretisation},
    Step{.read = read_track},
    Step{.read = read_rail},
    Step{.group = rail_position},
    Step{.group = rail_springs},
    Step{.group = wheelset, .replaces = "YTAPE"},
    Step{.read = read_wheel},
    Step{.group = wheelset_position, .replaces = "S_WS X_WS Z_WS FZ"},
    Step{.group = wheelset_velocity, .replaces = "VS RPITCH VPITCH FX"},
    Step{.group = wheel_position},
    Step{.group = wheel_velocity},
    Step{.read = read_subsurface},
};

}  // namespace

std::span<const Step> steps_on_rails() {
    return steps_of_rails;
}

}  // namespace contactd::contact_files

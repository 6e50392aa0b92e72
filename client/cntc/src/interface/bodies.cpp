// Sets the materials of the bodies, the interfacial layer and the friction.
#include <string>
#include <vector>

#include "given/checks.hpp"
#include "given/given_bodies.hpp"
#include "given/given_friction.hpp"
#include "handles/control_digits.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Methods of damping; the other methods are those of materials.
enum Method { undamped = 10, keeps_damping = 11, damped = 12 };

/// Throws Refused for damping, which contactd does not support.
void set_damping(Settings& settings, int method, const double* rparam, const int* nparam) {
    if (method == undamped) return;
    if (method == keeps_damping) {
        if (const auto refused = settings.refused.find("damping"); refused != settings.refused.end())
            throw refused->second;
        return;
    }
    const auto given = list(rparam, nparam, 4, "rparam");
    require_undamped(given[0], given[1]);
}

void set_bodies(Settings& settings, int method, const double* rparam, const int* nparam) {
    const auto count = material_numbers(method);
    if (!count)
        throw Refused(error_code::input,
                      "Material method " + std::to_string(method) +
                          " is not supported; use 0 for elastic bodies, 1 for viscoelastic ones, 3 or 5 for the "
                          "simplified theory, 4 for an interfacial layer, or 10, 11 or 12 for damping.");
    set_material(settings, method, list(rparam, nparam, *count, "rparam"), settings.units);
    set_flag_digit(settings, flag::material, method);
    settings.refused.erase("flag " + std::to_string(flag::material));
}

/// Returns the friction of a method: the law, plus ten times the kind of its variation.
GivenFriction friction_of(int method, const double* params, const int* nparam, const Settings& settings) {
    const bool on_rails = settings.module == module_number::wheel_rail;
    const int law = method % 10, varies = method / 10, size = friction_numbers(law);
    if (method < 0 || size == 0 || varies > (on_rails ? varies::along_track : varies::nowhere))
        throw Refused(error_code::friction,
                      "Friction method " + std::to_string(method) + " is not supported; use 0, 2, 3, 4, 5 or 6" +
                          (on_rails ? ", plus 10 for friction by the rail's angle or 20 for friction along the track."
                                    : ". Friction of basic contact does not vary."));
    if (varies == varies::nowhere) return uniform_friction(law, list(params, nparam, size, "params"), settings.units);
    // Format: [count, and for each place its angle or position followed by the numbers of the law].
    const auto given = numbers(params, nparam, 1, "params");
    const int count = whole(given[0], "the number of friction positions");
    if (count < 1)
        throw Refused(error_code::friction,
                      "The number of friction positions is " + std::to_string(count) + "; it must be at least 1.");
    if (given.size() != 1 + static_cast<std::size_t>(count) * static_cast<std::size_t>(size + 1))
        throw Refused(error_code::friction, "Friction at " + std::to_string(count) + " positions requires 1 + " +
                                                std::to_string(count) + " x " + std::to_string(size + 1) +
                                                " values, but nparam is " + std::to_string(given.size()) + ".");
    std::vector<FrictionAt> places;
    for (auto at = given.begin() + 1; at != given.end(); at += size + 1)
        places.push_back({*at, {at + 1, at + 1 + size}});
    return varying_friction(law, varies, places, settings.units);
}

}  // namespace

extern "C" void cntc_setmaterialparameters(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    const bool is_damping = imeth != nullptr && *imeth >= undamped && *imeth <= damped;
    set("cntc_setmaterialparameters", ire, icp, is_damping ? "damping" : "material", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        (is_damping ? set_damping : set_bodies)(settings, method, rparam, nparam);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setmaterialparameters)

extern "C" void cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params) {
    set("cntc_setfrictionmethod", ire, icp, "friction", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        const bool keeps = method >= 0 && method % 10 == law::keeps;  // whatever its tens digit
        if (keeps && settings.friction) return;
        settings.friction = friction_of(method, params, nparam, settings);
        settings.digits.friction_law = settings.friction->method % 10;
        settings.refused.erase("flag " + std::to_string(flag::friction_law));
    });
}
CONTACTD_FORTRAN_NAME(cntc_setfrictionmethod)

// Sets position and motion of rail and wheelset.
#include <array>

#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Reads `least` to `most` numbers; omitted ones are zero.
template <std::size_t most>
std::array<double, most> given(const double* values, const int* count, int least) {
    const auto read = numbers(values, count, least, "rparam");
    if (read.size() > most)
        throw Refused(error_code::input, "rparam has " + std::to_string(read.size()) +
                                             " values; it must have at most " + std::to_string(most) + ".");
    std::array<double, most> all{};
    std::copy(read.begin(), read.end(), all.begin());
    return all;
}

[[noreturn]] void refuse_digit(const char* name, int digit, const char* possible) {
    throw Refused(error_code::input,
                  std::string(name) + " is " + std::to_string(digit) + "; it must be " + possible + ".");
}

using Six = std::array<double, 6>;

void set_dimensions(GivenTrack& track, const Six& values, const Units& units) {
    track.gauge_height = values[0] * units.length;
    if (track.gauge_height > 0) {
        track.gauge = positive(values[2], "gaugwd") * units.length;
    } else {
        track.rail_y = values[1] * units.length;
        track.rail_z = values[2] * units.length;
    }
    track.cant = values[3];
    track.roller_radius = values[4] * units.length;
    track.curvature = values[5] * units.curvature();
}

RailDeviation deviation_of(const Six& values, const Units& units) {
    const double mm = units.length;
    RailDeviation rail;
    rail.y = values[0] * mm;
    rail.z = values[1] * mm;
    rail.roll = values[2];
    rail.y_velocity = values[3] * mm;
    rail.z_velocity = values[4] * mm;
    rail.roll_velocity = values[5];
    return rail;
}

/// Eleven numbers do not include the curvature of the track.
void set_both(RailSettings& rail, const double* values, const int* count, const Units& units) {
    constexpr int without_curvature = 11;
    const auto all = given<12>(values, count, without_curvature);
    const bool has_curvature = *count > without_curvature;
    const std::size_t behind = has_curvature ? 6 : 5;
    Six dimensions{}, deviation{};
    std::copy_n(all.begin(), behind, dimensions.begin());
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(behind), deviation.size(), deviation.begin());
    set_dimensions(rail.track, dimensions, units);
    rail.deviation = deviation_of(deviation, units);
}

/// The fifth number, where another program starts its search, is ignored.
void set_springs(GivenTrack& track, const double* values, const int* count, const Units& units) {
    const auto all = given<5>(values, count, 4);
    if (all[0] < 0 || all[2] < 0)
        throw Refused(error_code::input, "A stiffness of the rail's springs is negative; it must be at least 0.");
    track.spring_y = all[0] / units.length;
    track.spring_force_y = all[1];
    track.spring_z = all[2] / units.length;
    track.spring_force_z = all[3];
}

int wheel_digit(const int* ewheel) {
    constexpr int most = 8;
    const int digit = integer(ewheel, "ewheel");
    if (digit < 0 || digit > most) refuse_digit("ewheel", digit, "0 to 8");
    return digit;
}

}  // namespace

extern "C" void cntc_settrackdimensions(int* ire, int* ztrack, int* nparam, double* rparam) {
    set_rail("cntc_settrackdimensions", ire, "track", [&](RailSettings& rail, const Units& units) {
        switch (const int digit = integer(ztrack, "ztrack")) {
            case 0:
                return;
            case 1:
                return set_dimensions(rail.track, given<6>(rparam, nparam, 5), units);
            case 2:
                rail.deviation = deviation_of(given<6>(rparam, nparam, 6), units);
                return;
            case 3:
                return set_both(rail, rparam, nparam, units);
            case 32:
            case 33:
                return set_springs(rail.track, rparam, nparam, units);
            default:
                refuse_digit("ztrack", digit, "0 to 3, 32 or 33");
        }
    });
}
CONTACTD_FORTRAN_NAME(cntc_settrackdimensions)

extern "C" void cntc_setwheelsetdimensions(int* ire, int* ewheel, int* nparam, double* rparam) {
    set_rail("cntc_setwheelsetdimensions", ire, "wheelset", [&](RailSettings& rail, const Units& units) {
        // With the digits 4 and 6, some versions expect dimensions and others do not.
        const int digit = wheel_digit(ewheel);
        if (digit < 3 || ((digit == 4 || digit == 6) && integer(nparam, "nparam") == 0)) return;
        const auto all = given<4>(rparam, nparam, 3);
        rail.wheelset = {all[0] * units.length, all[1] * units.length, positive(all[2], "nomrad") * units.length};
    });
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetdimensions)

extern "C" void cntc_setwheelsetposition(int* ire, int* ewheel, int* nparam, double* rparam) {
    set_rail("cntc_setwheelsetposition", ire, "wheelset position", [&](RailSettings& rail, const Units& units) {
        if (wheel_digit(ewheel) == 0) return;
        const auto [s, y, z, roll, yaw, pitch] = given<6>(rparam, nparam, 6);
        const double mm = units.length;
        rail.position = {y * mm, z * mm, roll, yaw, s * mm, pitch};
    });
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetposition)

extern "C" void cntc_setwheelsetvelocity(int* ire, int* ewheel, int* nparam, double* rparam) {
    set_rail("cntc_setwheelsetvelocity", ire, "wheelset velocity", [&](RailSettings& rail, const Units& units) {
        if (wheel_digit(ewheel) < 2 && integer(nparam, "nparam") == 0) return;
        const auto [first, vy, vz, roll, yaw, pitch] = given<6>(rparam, nparam, 6);
        const double mm = units.length;
        rail.velocity = {first, vy * mm, vz * mm, roll, yaw, pitch};
        rail.velocity_length = mm;
    });
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetvelocity)

extern "C" void cntc_setwheelsetflexibility(int* ire, int* ewheel, int* nparam, double* rparam) {
    set_rail("cntc_setwheelsetflexibility", ire, "wheelset flexibility", [&](RailSettings& rail, const Units& units) {
        const int digit = wheel_digit(ewheel);
        if (digit == 0) return;
        // With the digit 4, some versions expect a flexibility and others do not.
        if (digit < 4 || (digit == 4 && integer(nparam, "nparam") == 0)) {
            rail.flexibility = {};
            return;
        }
        const auto v = given<12>(rparam, nparam, 12);
        const double mm = units.length;
        // The pitch is ignored: a round wheel is the same at every pitch, and the other program does not rotate it.
        rail.flexibility = {v[0] * mm, v[1] * mm, v[2] * mm, v[3], v[4],  0,
                            v[6] * mm, v[7] * mm, v[8] * mm, v[9], v[10], v[11]};
    });
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetflexibility)

extern "C" void cntc_setverticalforce(int* ire, double* fz) {
    with_rail("cntc_setverticalforce", ire, [&](RailCase& rail, Settings& common) {
        set_part(rail.settings, "vertical force", [&](RailSettings& settings) {
            settings.Fz = positive(number(fz, "fz"), "fz");
            common.digits.normal = 1;
        });
    });
}
CONTACTD_FORTRAN_NAME(cntc_setverticalforce)

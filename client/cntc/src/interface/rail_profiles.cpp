// Sets profiles of a wheel and a rail from files and tables, and returns them as tables.
#include <algorithm>
#include <cstring>

#include "answers/profile_values.hpp"
#include "given/given_profile.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Optional numbers at the end of an array.
template <class Number>
struct Optional {
    const Number* values;
    int count;

    Number operator()(int index, Number otherwise) const { return index < count ? values[index] : otherwise; }
};

Optional<int> optional_integers(const int* values, const int* count, const char* name) {
    return {values, static_cast<int>(integers(values, count, 0, name).size())};
}

Optional<double> optional_numbers(const double* values, const int* count, const char* name) {
    return {values, static_cast<int>(numbers(values, count, 0, name).size())};
}

ProfileOptions options_of(const Optional<int>& ints, const Optional<double>& reals, const Units& units) {
    ProfileOptions options = profile_options(
        {ints(2, 0), ints(3, 0), ints(5, 0), reals(0, 0), reals(1, 0), reals(4, 0), reals(5, 0), reals(6, -1)}, units);
    if (const int type = ints(0, -1); type == 0 || type == 1) options.wheel = type == 1;
    return options;
}

/// Reads the profile of the wheel or the rail. If it cannot be used, only its own part is refused.
template <class Read>
void set_profile(const char* function, const int* ire, const int* nints, const int* iparam, const int* nreals,
                 const double* rparam, const Read& read) {
    std::string part = "profile";
    if (nints != nullptr && *nints > 0 && iparam != nullptr && (iparam[0] == 0 || iparam[0] == 1))
        part = iparam[0] == 1 ? "wheel profile" : "rail profile";
    with_rail(function, ire, [&](RailCase& rail, const Settings& common) {
        set_part(rail.settings, part, [&](RailSettings& settings) {
            ReadProfile found = read(options_of(optional_integers(iparam, nints, "iparam"),
                                                optional_numbers(rparam, nreals, "rparam"), common.units));
            (found.wheel ? settings.wheel : settings.rail) = std::move(found.surface);
            settings.refused.erase(found.wheel ? "wheel profile" : "rail profile");
        });
    });
}

void get_values(const char* function, const int* ire, const int* itask, const Optional<int>& ints,
                const Optional<double>& reals, double* values, const int* lenarr) {
    with_rail(function, ire, [&](RailCase& rail, const Settings& common) {
        constexpr int whether_loaded = -1, gauge = 3;
        const ProfileQuery query{integer(itask, "itask"), ints(0, 0) == 1, ints(1, 0), reals(0, 1)};
        const auto out = room(values, lenarr, 1, "values");
        if (query.task == whether_loaded) {
            const GivenSurface& surface = query.wheel ? rail.settings.wheel : rail.settings.rail;
            const auto& refused = rail.settings.refused;
            const bool failed =
                refused.contains("profile") || refused.contains(query.wheel ? "wheel profile" : "rail profile");
            out[0] = failed || surface.empty() ? error_code::profile : 0;
            if (out.size() > 1) out[1] = failed ? error_code::profile : surface.empty() ? 1 : 0;
            return;
        }
        out[0] = error_code::profile;  // programs check this value
        if ((query.wheel ? rail.settings.wheel : rail.settings.rail).empty())
            throw Refused(error_code::profile, "This profile was not set; call cntc_setprofileinputfname.");
        std::vector<double> found =
            profile_values(query, outlines_of(rail, common), [&] { return frames_of(rail, common); });
        if (query.task == gauge)
            for (double& value : found) value /= common.units.length;
        std::copy_n(found.begin(), std::min(found.size(), out.size()), out.begin());
    });
}

}  // namespace

extern "C" void cntc_setprofileinputfname(int* ire, const char* name, int* len_name, int* nints, int* iparam,
                                          int* nreals, double* rparam) {
    set_profile("cntc_setprofileinputfname", ire, nints, iparam, nreals, rparam, [&](const ProfileOptions& options) {
        const int length = integer(len_name, "len_name");
        require(name, "name");
        if (length < 1) throw Refused(error_code::profile, "The name of the profile is empty.");
        std::string file(name, strnlen(name, static_cast<std::size_t>(length)));
        file.erase(file.find_last_not_of(' ') + 1);  // Fortran fills up
        return profile_from_file(file, options, FilesInFolder({}));
    });
}
CONTACTD_FORTRAN_NAME(cntc_setprofileinputfname)

extern "C" void cntc_setprofileinputvalues(int* ire, int* npoint, double* values, int* nints, int* iparam, int* nreals,
                                           double* rparam) {
    set_profile("cntc_setprofileinputvalues", ire, nints, iparam, nreals, rparam, [&](const ProfileOptions& options) {
        const int points = integer(npoint, "npoint");
        if (points < 2 || static_cast<std::size_t>(points) > most_profile_points)
            throw Refused(error_code::profile, "A profile has " + std::to_string(points) +
                                                   " points; it must have 2 to " + std::to_string(most_profile_points) +
                                                   ".");
        const int count = 2 * points;
        return profile_from_values(numbers(values, &count, count, "values"), options);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setprofileinputvalues)

extern "C" void cntc_getprofilevalues_new(int* ire, int* itask, int* nints, int* iparam, int* nreals, double* rparam,
                                          int* lenarr, double* values) {
    clear(values, lenarr);
    constexpr const char* function = "cntc_getprofilevalues_new";
    Optional<int> ints{};
    Optional<double> reals{};
    const int code = answer(function, [&] {
        ints = optional_integers(iparam, nints, "iparam");
        reals = optional_numbers(rparam, nreals, "rparam");
    });
    if (code == 0) get_values(function, ire, itask, ints, reals, values, lenarr);
}
CONTACTD_FORTRAN_NAME(cntc_getprofilevalues_new)

extern "C" void cntc_getprofilevalues(int* ire, int* itask, int* nints, int* iparam, int* lenarr, double* values) {
    clear(values, lenarr);
    constexpr const char* function = "cntc_getprofilevalues";
    Optional<int> ints{};
    const int code = answer(function, [&] { ints = optional_integers(iparam, nints, "iparam"); });
    if (code == 0) get_values(function, ire, itask, ints, {}, values, lenarr);
}
CONTACTD_FORTRAN_NAME(cntc_getprofilevalues)

#include "wheelset_conicity.hpp"

#include <string>

#include "contactd/equivalent_conicity.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"

namespace contactd::engine {
namespace {

/// The field of `error` with another name in place of its first `length` characters.
InvalidArgument renamed(const InvalidArgument& error, const std::string& name, std::size_t length) {
    const std::string &field = error.field(), sentence = error.what();
    return {name + field.substr(length), sentence.substr(field.size() + 1)};
}

ProfileCurve curve_of(const ProfileSpec& profile, const std::string& name) {
    try {
        return make_profile(profile).curve;
    } catch (const InvalidArgument& error) {
        throw renamed(error, "setup." + name, std::string("profile").size());
    }
}

}  // namespace

std::vector<EquivalentConicity> wheelset_conicities(const WheelRailSetup& setup, const ConicityRequest& wanted,
                                                    const Observer& observer) {
    if (!setup.rail_slices.empty())
        throw InvalidArgument("setup.rail_slices",
                              "are given; the conicity is that of a rail that does not vary along the track");
    const ProfileCurve wheel = curve_of(setup.wheel, "wheel"), rail = curve_of(setup.rail, "rail");
    try {
        return equivalent_conicities(wheelset_on_track(wheel, rail, setup.track, setup.wheelset), wanted.amplitudes,
                                     wanted.settings, observer);
    } catch (const InvalidArgument& error) {
        const std::string& field = error.field();
        if (field.starts_with("track.") || field.starts_with("wheelset.")) throw renamed(error, "setup.", 0);
        if (field != "shift") throw renamed(error, "conicity.", 0);
        throw InvalidArgument("conicity.amplitudes", "lead to a " + std::string(error.what()));
    }
}

}  // namespace contactd::engine

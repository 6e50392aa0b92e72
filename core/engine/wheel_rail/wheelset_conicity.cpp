#include "wheelset_conicity.hpp"

#include <string>
#include <string_view>

#include "contactd/equivalent_conicity.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/wheelset_contacts.hpp"

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
        throw renamed(error, name, std::string("profile").size());
    }
}

/// `name` is where the set-up stands.
WheelOverRail side_of(const WheelRailSetup& setup, const std::string& name) {
    if (!setup.rail_slices.empty())
        throw InvalidArgument(name + ".rail_slices",
                              "are given; a rigid wheelset is told for rails that do not vary along the track");
    if (!setup.wheel_slices.empty())
        throw InvalidArgument(name + ".wheel_slices", "are given; a rigid wheelset is told for wheels that are round");
    const ProfileCurve wheel = curve_of(setup.wheel, name + ".wheel"), rail = curve_of(setup.rail, name + ".rail");
    try {
        return wheel_over_rail(wheel, rail, setup.track, setup.wheelset);
    } catch (const InvalidArgument& error) {
        throw renamed(error, name + ".", 0);
    }
}

WheelsetOnTrack wheelset_of(const WheelsetSetup& setup) {
    const WheelOverRail right = side_of(setup.setup, "setup");
    return {setup.left ? side_of(*setup.left, "left") : right, right};
}

PlacedProfiles placed(const WheelOverRail& side) {
    return {side.wheel.points(), side.rail.points(), side.wheel_origin, side.rail_origin};
}

}  // namespace

std::vector<EquivalentConicity> wheelset_conicities(const WheelsetSetup& setup, const ConicityRequest& wanted,
                                                    const Observer& observer) {
    const WheelsetOnTrack wheelset = wheelset_of(setup);
    try {
        return equivalent_conicities(wheelset, wanted.amplitudes, wanted.settings, observer);
    } catch (const InvalidArgument& error) {
        constexpr std::string_view right = "right.", left = "left.";
        if (error.field() == "shift")
            throw InvalidArgument("conicity.amplitudes", "lead to a " + std::string(error.what()));
        if (error.field().starts_with(right)) throw renamed(error, "setup.", right.size());
        if (error.field().starts_with(left) && setup.left) throw;
        if (error.field().starts_with(left)) throw renamed(error, "setup.", left.size());
        throw renamed(error, "conicity.", 0);
    }
}

std::vector<WheelsetContacts> wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& wanted,
                                                const Observer& observer) {
    const WheelsetOnTrack wheelset = wheelset_of(setup);
    std::vector<WheelsetContacts> contacts;
    for (const double shift : wanted.shifts) {
        observer.throw_if_cancelled();
        try {
            contacts.push_back(contacts_at(wheelset, shift, wanted.roll));
        } catch (const InvalidArgument& error) {
            throw renamed(error, "contacts.shifts[" + std::to_string(contacts.size()) + "]", error.field().size());
        }
    }
    return contacts;
}

ProfilesOfSides placed_profiles(const WheelsetSetup& setup) {
    const WheelsetOnTrack wheelset = wheelset_of(setup);
    return {placed(wheelset.left), placed(wheelset.right)};
}

}  // namespace contactd::engine

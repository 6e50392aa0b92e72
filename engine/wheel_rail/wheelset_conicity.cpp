#include "wheelset_conicity.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "contactd/below.hpp"
#include "contactd/conicity_warnings.hpp"
#include "contactd/equivalent_conicity.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/wheelset_contacts.hpp"

namespace contactd::engine {
namespace {

/// Holds placed profiles, and the evidence of their preparation.
struct Side {
    WheelOverRail profiles;
    ProfileEvidence wheel, rail;
};

Profile profile_of(const ProfileSpec& profile, const std::string& name) {
    return renaming(in_place_of("profile", name), [&] { return make_profile(profile); });
}

/// `name` is the field of the set-up.
Side side_of(const WheelRailSetup& setup, const std::string& name) {
    if (!setup.rail_slices.empty())
        throw InvalidArgument(
            name + ".rail_slices",
            "are given, but contacts of a rigid wheelset require a rail that does not vary along the track");
    if (!setup.wheel_slices.empty())
        throw InvalidArgument(name + ".wheel_slices",
                              "are given, but contacts of a rigid wheelset require round wheels");
    Profile wheel = profile_of(setup.wheel, name + ".wheel"), rail = profile_of(setup.rail, name + ".rail");
    return {below(name, [&] { return wheel_over_rail(wheel.curve, rail.curve, setup.track, setup.wheelset); }),
            std::move(wheel.evidence), std::move(rail.evidence)};
}

WheelsetOnTrack wheelset_of(const WheelsetSetup& setup) {
    const WheelOverRail right = side_of(setup.setup, "setup").profiles;
    return {setup.left ? side_of(*setup.left, "left").profiles : right, right};
}

PlacedProfiles placed(const Side& side) {
    const WheelOverRail& both = side.profiles;
    return {both.wheel.points(), both.rail.points(), both.wheel_origin, both.rail_origin, side.wheel, side.rail};
}

void add(std::vector<std::string>& warnings, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences)
        if (std::ranges::find(warnings, sentence) == warnings.end()) warnings.push_back(sentence);
}

}  // namespace

std::vector<EquivalentConicity> wheelset_conicities(const WheelsetSetup& setup, const ConicityRequest& request,
                                                    const Observer& observer) {
    const WheelsetOnTrack wheelset = wheelset_of(setup);
    const auto rename = [&](const std::string& field) {
        if (setup.left && field.starts_with("left.")) return field;
        for (const char* side : {"right.", "left."})
            if (field.starts_with(side)) return in_place_of(side, "setup.")(field);
        return "conicity." + field;
    };
    return renaming(rename, [&] {
        try {
            return equivalent_conicities(wheelset, request.amplitudes, request.settings, observer);
        } catch (const InvalidArgument& error) {
            if (error.field() != "shift") throw;
            throw InvalidArgument("amplitudes", "lead to a shift that " + error.problem());
        }
    });
}

std::vector<WheelsetContacts> wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& request,
                                                const Observer& observer) {
    const WheelsetOnTrack wheelset = wheelset_of(setup);
    std::vector<WheelsetContacts> contacts;
    for (const double shift : request.shifts) {
        observer.throw_if_cancelled();
        const std::string name = "contacts.shifts[" + std::to_string(contacts.size()) + "]";
        contacts.push_back(renaming([&](const std::string&) { return name; },
                                    [&] { return contacts_at(wheelset, shift, request.roll); }));
    }
    return contacts;
}

std::vector<std::string> wheelset_warnings(const WheelsetSetup& setup, const std::optional<ContactsRequest>& contacts,
                                           const std::optional<ConicityRequest>& conicity) {
    std::vector<std::string> warnings;
    for (const auto& [side, name] :
         {std::pair(&setup.setup, "setup"), std::pair(setup.left ? &*setup.left : nullptr, "left")}) {
        if (side == nullptr) continue;
        const Side found = side_of(*side, name);
        add(warnings, found.wheel.warnings);
        add(warnings, found.rail.warnings);
    }
    if (contacts) add(warnings, unit_warnings(*contacts));
    if (conicity) add(warnings, unit_warnings(*conicity));
    return warnings;
}

ProfilesOfSides placed_profiles(const WheelsetSetup& setup) {
    const PlacedProfiles right = placed(side_of(setup.setup, "setup"));
    return {setup.left ? placed(side_of(*setup.left, "left")) : right, right};
}

}  // namespace contactd::engine

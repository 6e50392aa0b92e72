// Computes contacts, equivalent conicity and placed profiles of a rigid wheelset with the profiles of a set-up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/conicity.hpp"
#include "contactd/observer.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd::engine {

/// Throws InvalidArgument naming "setup.rail.points", "left.rail.points", "conicity.amplitudes[i]", ..., and Cancelled.
std::vector<EquivalentConicity> wheelset_conicities(const WheelsetSetup& setup, const ConicityRequest& request,
                                                    const Observer& observer);

/// Returns contacts in the order of the shifts. Throws InvalidArgument naming "setup.rail.points",
/// "contacts.shifts[i]", ..., and Cancelled.
std::vector<WheelsetContacts> wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& request,
                                                const Observer& observer);

/// Returns sentences about profiles, and about shifts and amplitudes that are probably meant in another unit. Throws
/// InvalidArgument naming "setup.rail.points", ...
std::vector<std::string> wheelset_warnings(const WheelsetSetup& setup, const std::optional<ContactsRequest>& contacts,
                                           const std::optional<ConicityRequest>& conicity);

/// Throws InvalidArgument naming "setup.rail.points", ...
ProfilesOfSides placed_profiles(const WheelsetSetup& setup);

}  // namespace contactd::engine

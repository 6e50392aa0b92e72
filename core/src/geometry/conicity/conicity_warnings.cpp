#include "contactd/conicity_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "types/units/plausibility.hpp"

namespace contactd {

std::vector<std::string> unit_warnings(const ContactsRequest& request) {
    double largest = 0;
    for (const double shift : request.shifts) largest = std::max(largest, std::abs(shift));
    std::vector<std::string> warnings;
    if (const auto sentence = doubt(Quantity::lateral_position, "contacts.shifts are at most", largest))
        warnings.push_back(*sentence);
    return warnings;
}

std::vector<std::string> unit_warnings(const ConicityRequest& request) {
    double largest = 0;
    for (const double amplitude : request.amplitudes) largest = std::max(largest, amplitude);
    std::vector<std::string> warnings;
    if (const auto sentence = doubt(Quantity::lateral_amplitude, "conicity.amplitudes are at most", largest))
        warnings.push_back(*sentence);
    if (const auto sentence =
            doubt(Quantity::contact_distance, "conicity.contact_distance is", request.settings.contact_distance))
        warnings.push_back(*sentence);
    return warnings;
}

}  // namespace contactd

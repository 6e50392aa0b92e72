#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "steps.hpp"

namespace contactd::contact_files {
namespace {

constexpr int most_sets = 10;  // for V = 1 and 2
constexpr double least_share = 1e-8, least_slip_velocity = 1e-4;

constexpr std::array<std::string_view, 2> of_coulomb{"FSTAT", "FKIN"};
constexpr std::array<std::string_view, 4> by_temperature{"FREF", "TREF", "DFHEAT", "DTHEAT"};
constexpr std::array<std::string_view, 5> of_falling{"FKIN", "F1", "SABSH1", "F2", "SABSH2"};

std::string group_of_law(int law) {
    std::string group;
    for (const std::string_view name : names_of_friction(law)) group += (group.empty() ? "" : " ") + std::string(name);
    return group;
}

/// Reads a set of numbers, and raises slip velocities of terms that are zero, as CONTACT does.
ByName<double> read_set(Reading& reading, const std::string& group) {
    ByName<double> set;
    for (const auto& [name, value] : read_values(reading, group)) set[name] = std::get<double>(value);
    const auto raise = [&](const char* share, const char* slip_velocity) {
        const auto found = set.find(slip_velocity);
        if (found != set.end() && set[share] < least_share)
            found->second = std::max(found->second, least_slip_velocity);
    };
    raise("F1", "SABSH1");
    raise("F2", "SABSH2");
    if (set.contains("FSTAT") && std::abs(set["FSTAT"] - set["FKIN"]) > 1e-3 * std::abs(set["FSTAT"]))
        reading.fail_case(
            "has different FSTAT and FKIN; use equal values with L = 0, or L = 2, 3 or 4 for friction that falls with "
            "slip");
    return set;
}

int number_of_sets(Reading& reading) {
    const int count = std::get<int>(read_values(reading, "NVF#").at("NVF"));
    if (count < 1 || count > most_sets)
        reading.lines.fail(reading.lines.words().front(),
                           "has NVF = " + std::to_string(count) + "; friction must have 1 to 10 sets of values");
    return count;
}

}  // namespace

std::span<const std::string_view> names_of_friction(int law) {
    if (law == 0) return of_coulomb;
    if (law == 6) return by_temperature;
    return of_falling;
}

void read_friction(Reading& reading) {
    const int law = reading.digit("L"), varies = reading.digit("V");
    if (law == 1) return;
    const std::string values = group_of_law(law);
    const std::string place = varies == 1 ? "ALPHVF" : "SVF";
    ContactFrictionSets sets;
    if (varies == 0) {
        sets.push_back(read_set(reading, values));
    } else if (varies == 3) {
        const int rows = reading.integer("MY");
        if (rows < 1) reading.lines.fail_line("requires MY before the friction of each row (V = 3)");
        for (int row = 1; row <= rows; ++row) {
            sets.push_back(read_set(reading, values));
            sets.back()["IY"] = row;
        }
    } else {
        const int count = number_of_sets(reading);
        for (int i = 0; i < count; ++i) {
            sets.push_back(read_set(reading, place + (varies == 1 ? "^ " : " ") + values));
            if (i > 0 && sets[i].at(place) <= sets[i - 1].at(place))
                reading.fail_case("has a " + place +
                                  " that is not larger than that of the previous set; they must increase");
        }
    }
    reading.result.friction = std::make_shared<const ContactFrictionSets>(std::move(sets));
    reading.result.read.push_back("friction");
    if (law != 0) read_group(reading, "MEMDST MEM_S0");
}

}  // namespace contactd::contact_files

#include "case_rules.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "case_digits.hpp"
#include "contactd/friction_along_track.hpp"
#include "steps.hpp"
#include "types/units/plain_text.hpp"

namespace contactd::contact_files {
namespace {

std::string setting(const Reading& reading, const char* name) {
    return std::string(name) + " = " + std::to_string(reading.digit(name));
}

void begin_history(Reading& reading) {
    for (const auto& [name, right] : {std::pair("P", 2), std::pair("I", 0)}) {
        if (reading.digit(name) == right) continue;
        reading.warn("has " + setting(reading, name) + ", but no case precedes the first case of a history; " +
                     std::to_string(right) + " is used instead");
        reading.result.digits[name] = right;
    }
    if (reading.digit("L") == 1)
        reading.fail_case("has L = 1, which keeps the friction of the previous case, but this is the first case");
    if (reading.digit("D") == 0)
        reading.fail_case("has D = 0, which keeps the grid of the previous case, but this is the first case");
    if (reading.digit("S") == 1 || reading.digit("S") == 2)
        reading.fail_case("has " + setting(reading, "S") +
                          ", which keeps the points of the previous case, but this is the first case");
}

void go_on(Reading& reading, const History& history) {
    if (history.failed > 0 && reading.digit("P") != 2)
        reading.fail_case("has " + setting(reading, "P") + ", which continues case " + std::to_string(history.failed) +
                          ", but that case has errors");
    const auto before_of = [&](const char* name) { return digit(history.last, name); };
    if (reading.digit("N") != before_of("N") && reading.result.module_number == 1 && reading.digit("E") == 0)
        reading.fail_case("has " + setting(reading, "N") +
                          ", different from the previous case; give the position anew with E = 1 or more");
    if (reading.digit("V") != before_of("V") && reading.digit("L") == 1)
        reading.fail_case("has " + setting(reading, "V") +
                          ", different from the previous case; give friction anew with L other than 1");
    const bool shifts = reading.digit("T") == 1, shifted = before_of("T") == 1;
    const bool rolls = reading.digit("T") >= 2, rolled = before_of("T") >= 2;
    if (reading.result.module_number == 3 && ((shifts && rolled) || (rolls && shifted)) && reading.digit("C") == 0)
        reading.fail_case("has C = 0 between a shift and rolling; set C to 1 or more");
}

/// Adds errors for digits that are inconsistent with each other.
void check_digits(Reading& reading) {
    const auto is = [&](const char* name, int value) { return reading.digit(name) == value; };
    if (reading.digit("H") > 0 && !is("T", 3))
        reading.fail_case("has " + setting(reading, "H") + ", temperatures, with " + setting(reading, "T") +
                          "; temperatures require steady rolling, T = 3");
    if (reading.result.module_number == 3 && reading.digit("B") >= 5 && !is("N", 0))
        reading.fail_case("has " + setting(reading, "B") + " with N = 1; KPEC and ANALYN require N = 0");
    if (reading.result.module_number == 1 && is("F", 1) && !is("N", 1))
        reading.fail_case("has F = 1 with N = 0; a given FX requires a given FZ (N = 1)");
}

/// Stores digits that later cases can keep as values.
void note_kept(Reading& reading) {
    const auto note = [&](const char* name, const char* digit, bool is_new) {
        if (is_new) reading.set(name, reading.digit(digit));
    };
    note("GAUSEI", "G", reading.digit("G") != 1);
    note("FRCLAW", "L", reading.digit("L") != 1);
    note("VARFRC", "V", reading.digit("L") != 1);
    note("INFLCF", "C", reading.digit("C") >= 2);
    if (reading.result.module_number == 1)
        note("DISCNS", "D", reading.digit("D") >= 2);
    else
        note("EXRHS", "E", reading.digit("E") != 1);
}

/// Adds an error for a value that a digit requires and no case has given.
void need(Reading& reading, bool is_needed, const char* value, const char* by) {
    if (is_needed && !reading.has(value))
        reading.fail_case("ends a case with " + setting(reading, by) + ", which requires " + value +
                          ", but neither this case nor a previous one gives it");
}

void check_needs(Reading& reading) {
    const int material = reading.digit("M");
    need(reading, true, "POISS1", "C");
    need(reading, reading.digit("B") == 1, "FLXZ", "B");
    need(reading, material == 1, "FG1", "M");
    need(reading, material == 2, "FLX", "M");
    need(reading, material == 2 || material == 3 || material == 5, "K0", "M");
    need(reading, material == 4, "GG3", "M");
    need(reading, reading.digit("H") > 0, "BKTEMP1", "H");
    if (!reading.result.friction && reading.digit("L") == 1)
        reading.fail_case("ends a case with L = 1, which keeps friction, but no previous case gives it");
    if (!reading.result.subsurface && reading.digit("S") > 0)
        reading.fail_case("ends a case with " + setting(reading, "S") +
                          ", which requires points below the surface, but no previous case gives them");
}

void check_needs_alone(Reading& reading) {
    need(reading, true, "IPOTCN", "D");
    need(reading, reading.integer("IPOTCN") > 0, "IBASE", "Z");
    need(reading, reading.digit("T") >= 2, "CHI", "T");
    need(reading, reading.digit("E") == 1 && reading.integer("EXRHS") == 9, "SLIP_X", "E");
}

void check_needs_on_rails(Reading& reading) {
    const bool is_on_roller = reading.digit("C1") >= 4;
    need(reading, true, "DX", "D");
    need(reading, true, "GAUGHT", "Z");
    need(reading, true, is_on_roller ? "NOMRADR" : "CANT", "C1");
    need(reading, true, "RFNAME", "Z");
    need(reading, true, "WFNAME", "E");
    need(reading, true, is_on_roller ? "X_WS" : "S_WS", "E");
    need(reading, true, reading.digit("N") == 0 ? "Z_WS" : "FZ", "N");
    need(reading, reading.digit("T") > 0, is_on_roller ? "RPITCH" : "VS", "T");
    need(reading, reading.digit("T") > 0, reading.digit("F") == 1 ? "FX" : "VPITCH", "F");
    need(reading, reading.digit("F") == 3, "KYRAIL", "F");
}

/// Returns whether Dundurs' constant K is so small that the normal and tangential problems are not coupled.
bool are_bodies_alike(const Reading& reading) {
    const double g1 = reading.real("GG1"), g2 = reading.real("GG2");
    const double g = 2 / (1 / g1 + 1 / g2);
    const double k = g * ((1 - 2 * reading.real("POISS1")) / g1 - (1 - 2 * reading.real("POISS2")) / g2) / 4;
    return !(std::abs(k) >= 1e-4);
}

void check_values_alone(Reading& reading) {
    if (reading.has("FN") && reading.digit("N") == 1 && !(reading.real("FN") > 0))
        reading.fail_case("ends a case with FN = " + std::to_string(reading.real("FN")) +
                          "; the normal force must be positive");
    const int grid = reading.integer("IPOTCN");
    if ((grid == -4 || grid == -5) && reading.digit("N") == 0)
        reading.fail_case("ends a case with IPOTCN = " + std::to_string(grid) +
                          " and N = 0; a line contact requires its force, N = 1");
    if (reading.digit("B") == 4 && (grid != -6 || reading.digit("N") != 1))
        reading.fail_case("ends a case with B = 4, which requires IPOTCN = -6 and N = 1");
}

/// Returns the numbers of each set with their place SVF.
std::vector<ContactFrictionAtPlace> track_of(const ContactFrictionSets& sets, int law) {
    std::vector<ContactFrictionAtPlace> track;
    for (const ByName<double>& set : sets) {
        std::vector<double>& values = track.emplace_back(set.at("SVF")).values;
        for (const std::string_view name : names_of_friction(law)) values.push_back(set.find(name)->second);
    }
    return track;
}

void warn_of_thin_friction(Reading& reading) {
    constexpr int along_track = 2;
    if (reading.integer("VARFRC") != along_track || !reading.result.friction || reading.digit("T") == 0) return;
    const char* place = reading.digit("C1") >= 4 ? "X_WS" : "S_WS";
    const int law = reading.integer("FRCLAW");
    const auto thin = thin_friction(law, track_of(*reading.result.friction, law), reading.real(place));
    if (thin)
        reading.warn("ends a case with " + std::string(place) + " = " + plain_text(reading.real(place)) +
                     ", between friction at SVF = " + plain_text(thin->from) + " and " + plain_text(thin->to) +
                     " mm, whose coefficients differ by " + plain_text(thin->difference) +
                     ". Interpolation over such a distance is uncertain. Give friction at more places");
}

}  // namespace

History new_history(int module) {
    History history;
    history.last.module_number = module;
    auto& values = history.last.values;
    values = {{"MAXGS", 999}, {"MAXIN", 20}, {"MAXNR", 25}, {"MAXOUT", 1}, {"EPS", 1e-5}, {"GAUSEI", 0}};
    if (module == 1) values["NPOT_MAX"] = 20000;
    return history;
}

bool keeps_nothing(const Reading& reading) {
    const bool is_on_rails = reading.result.module_number == 1;
    return reading.digit("P") == 2 && reading.digit("I") == 0 && reading.digit("L") != 1 && reading.digit("D") >= 2 &&
           reading.digit("C") >= 2 && reading.digit("G") != 1 && reading.digit("H") != 1 &&
           (reading.digit("S") == 0 || reading.digit("S") == 3) &&
           (is_on_rails ? reading.digit("Z") == 3 && (reading.digit("E") == 3 || reading.digit("E") == 5)
                        : reading.digit("Z") >= 1 && reading.digit("E") != 1);
}

void apply_digits(Reading& reading, const History& history) {
    if (history.torn > 0 && !keeps_nothing(reading))
        reading.fail_case("begins a case that keeps data of case " + std::to_string(history.torn) +
                          ", which could not be read completely");
    else if (history.cases == 0)
        begin_history(reading);
    else
        go_on(reading, history);
    check_digits(reading);
    note_kept(reading);
    if (reading.digit("M2") == 0) reading.forget("CDAMPN CDAMPT DFNMAX DFTMAX");
}

void apply_values(Reading& reading) {
    check_needs(reading);
    const bool turn = reading.integer("INFLCF") == 4;  // Rotated half-spaces couple both problems.
    if (reading.has("POISS1") && are_bodies_alike(reading) && !turn) reading.set("MAXOUT", 1);
    if (reading.result.module_number == 1) {
        check_needs_on_rails(reading);
        return warn_of_thin_friction(reading);
    }
    if (reading.digit("T") == 1 || (reading.digit("T") == 0 && reading.digit("C") >= 2))
        for (const auto& [name, value] : {std::pair("CHI", 0.0), std::pair("DQ", 1.0), std::pair("VELOC", 1.0)})
            reading.set(name, value);
    check_needs_alone(reading);
    check_values_alone(reading);
}

}  // namespace contactd::contact_files

// Settings of a program: the values of a case, its units, and refused values.
#pragma once

#include <map>
#include <string>

#include "answers/stress_blocks.hpp"
#include "edge/codes.hpp"
#include "edge/refused.hpp"
#include "given/given.hpp"
#include "given/given_rail.hpp"
#include "given/units.hpp"

namespace contactd::cntc {

using namespace cases;

struct Settings : Given {
    int module = module_number::basic_contact;
    Units units = units_mm_on_body_1;
    std::map<int, double> metadata;
    std::map<int, GivenBlock> blocks;
    /// Refused settings, by name. Nothing is solved until they are corrected.
    std::map<std::string, Refused> refused;
};

struct RailSettings : GivenRail {
    /// Refused settings, by name. Nothing is solved until they are corrected.
    std::map<std::string, Refused> refused;
};

/// Throws the first refusal of these settings.
template <class Given>
void require_nothing_refused(const Given& settings) {
    if (!settings.refused.empty()) throw settings.refused.begin()->second;
}

}  // namespace contactd::cntc

// Warns of tables of longitudinally uniform bodies whose stated error exceeds the requested accuracy.
#pragma once

#include <string>
#include <vector>

#include "contactd/ic_table.hpp"

namespace contactd {

/// Returns a sentence if the stated error exceeds `accuracy`. It applies to tables and to all answers computed with
/// them.
std::vector<std::string> section_warnings(double accuracy, const SectionEvidence& evidence);

}  // namespace contactd

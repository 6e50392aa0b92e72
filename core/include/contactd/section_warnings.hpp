// Tables of longitudinally uniform bodies whose stated error is more than was asked for.
#pragma once

#include <string>
#include <vector>

#include "contactd/ic_table.hpp"

namespace contactd {

/// A sentence where the stated error exceeds `accuracy`, for tables and for all answers that are computed with them.
std::vector<std::string> section_warnings(double accuracy, const SectionEvidence& evidence);

}  // namespace contactd

// The cross-section of a prism.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/section.hpp"

namespace contactd::proto {

nlohmann::json encode_section(const Section& section);
/// Of what has passed its schema. Throws StatusError where there is not exactly one shape, or one curve of a part.
Section decode_section(const nlohmann::json& source, const std::string& field);

}  // namespace contactd::proto

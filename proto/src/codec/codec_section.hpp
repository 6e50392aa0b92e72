// Encodes and decodes the cross-section of a longitudinally uniform body.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/ic_spec.hpp"
#include "contactd/proto/frame.hpp"

namespace contactd::proto {

/// Encodes points of a profile as plain lists.
nlohmann::json encode_section(const Section& section);
/// Decodes the section of an object that has passed its schema. Throws StatusError unless there is exactly one shape,
/// and one curve for each part, and for points of a profile that are not pairs, whether in `frames` or not.
Section decode_section(const nlohmann::json& source, const Frames& frames, const std::string& field);

/// Decodes like decode_ics of codec_parts.hpp, for a request whose section may contain arrays.
Ics decode_ics(const nlohmann::json& json, const Frames& frames);

}  // namespace contactd::proto

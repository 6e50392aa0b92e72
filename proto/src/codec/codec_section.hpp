// The cross-section of a longitudinally uniform body.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/ic_spec.hpp"
#include "contactd/proto/frame.hpp"

namespace contactd::proto {

/// Points of a profile as plain lists.
nlohmann::json encode_section(const Section& section);
/// Section of an object that has passed its schema. Throws StatusError where there is not exactly one shape, or one
/// curve of a part, and for points of a profile that are no pairs, in `frames` or not.
Section decode_section(const nlohmann::json& source, const Frames& frames, const std::string& field);

/// Decodes as decode_ics of codec_parts.hpp does, for a request whose section may hold arrays.
Ics decode_ics(const nlohmann::json& json, const Frames& frames);

}  // namespace contactd::proto

// Encodes and decodes `evidence` of a table. A message contains only the parts that apply to the table's source.
#pragma once

#include "contactd/ic_table.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

nlohmann::json write_evidence(const IcEvidence& evidence, const MemberPath& path);

}  // namespace contactd::proto

// `evidence` of a table, of which a message has what applies to how it was made.
#pragma once

#include "contactd/ic_table.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

nlohmann::json write_evidence(const IcEvidence& evidence, const MemberPath& path);

}  // namespace contactd::proto

// Encodes and decodes `evidence` of a table.
#include "codec_evidence.hpp"
#include "contactd/fields/ic_table.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {

using nlohmann::json;

// A closed form and a table from the request have no build. Errors are present only if they were computed against a
// closed form or estimated.
json write_evidence(const IcEvidence& evidence, const MemberPath& path) {
    json result = write_object(type_of<IcEvidence>(), &evidence, path, {});
    const bool is_built = evidence.elements > 0;
    if (is_built)
        result.emplace("load_cases", json::array());
    else
        for (const char* of_build : {"elements", "dofs", "processes", "seconds"}) result.erase(of_build);
    if ((is_built && !evidence.section) || evidence.errors.zz)
        result.emplace("errors", json::object());
    else
        for (const char* error : {"errors", "errors_estimated"}) result.erase(error);
    if (!evidence.imported) result.erase("imported");
    return result;
}

json encode_evidence(const IcEvidence& evidence) {
    return write_answer(evidence, MemberPath("evidence"));
}

IcEvidence decode_evidence(const json& source) {
    IcEvidence evidence;
    read_fields(source, evidence, MemberPath("evidence"));
    return evidence;
}

}  // namespace contactd::proto

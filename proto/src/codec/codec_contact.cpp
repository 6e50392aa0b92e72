// Encodes and decodes requests of contact.solve.
#include "codec_parts.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_opening(const ContactProblem& problem, ArrayWriter& arrays) {
    if (problem.Fn && problem.approach) require_load(problem);
    json params = write_fields(problem, MemberPath(""), {&arrays, &problem.grid});
    encode_bodies(problem, params, arrays);
    return params;
}

// Reads the fields first: the model determines how coefficients are read, and the grid determines the shape of arrays.
ContactProblem decode_opening(const json& params, const Frames& frames) {
    ContactProblem problem;
    read_fields(params, problem, MemberPath(""), {frames, &problem.grid});
    decode_bodies(params, frames, problem);
    return problem;
}

json encode_problem(const ContactProblem& problem, ArrayWriter& arrays) {
    require_load(problem);
    if (!problem.gap) throw InvalidArgument("gap", "is missing; give the distance between the undeformed surfaces");
    return encode_opening(problem, arrays);
}

ContactProblem decode_problem(const json& params, const Frames& frames) {
    return decode_opening(params, frames);
}

}  // namespace contactd::proto

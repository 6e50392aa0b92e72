// Encodes and decodes the motion in a result: the fields of `friction` of a request or, in rolling, those of its field
// `rolling`.
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/session.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_motion(const Motion& motion) {
    StepInput step;
    step.motion = motion;
    json friction = write_object(type_of<FrictionFields<StepInput>>(), &step, MemberPath("friction"), {});
    return std::holds_alternative<Rolling>(motion) ? std::move(friction["rolling"]) : friction;
}

Motion decode_motion(const json& source) {
    StepInput step;
    const bool is_shift = source.contains("rigid_shift");
    read_fields(is_shift ? source : json{{"rolling", source}}, type_of<FrictionFields<StepInput>>(), &step,
                MemberPath("friction"), {{}});
    return *step.motion;
}

}  // namespace contactd::proto

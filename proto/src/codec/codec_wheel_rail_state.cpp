// `state` of wheelrail.*.
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "field_codec.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_wheel_rail_state(const WheelRailState& state) {
    return write_fields(state, MemberPath("state"));
}

WheelRailState decode_wheel_rail_state(const json& source) {
    WheelRailState state;
    read_fields(source, state, MemberPath("state"));
    return state;
}

json encode_wheelset_state(const WheelsetState& state) {
    return write_fields(state, MemberPath("state"));
}

WheelsetState decode_wheelset_state(const json& source) {
    WheelsetState state;
    read_fields(source, state, MemberPath("state"));
    return state;
}

}  // namespace contactd::proto

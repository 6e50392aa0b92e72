// `state` of wheelrail.*.
#include <utility>

#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "named_numbers.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

// Each of something that may be const.
template <class Part>
auto numbers_of_position(Part& position) {
    return named(std::pair("y", &position.y), std::pair("z", &position.z), std::pair("roll", &position.roll),
                 std::pair("yaw", &position.yaw), std::pair("x", &position.x), std::pair("pitch", &position.pitch));
}

template <class Part>
auto numbers_of_velocity(Part& velocity) {
    return named(std::pair("x", &velocity.x), std::pair("y", &velocity.y), std::pair("z", &velocity.z),
                 std::pair("roll", &velocity.roll), std::pair("yaw", &velocity.yaw),
                 std::pair("pitch", &velocity.pitch));
}

template <class Part>
auto numbers_of_rail(Part& rail) {
    return named(std::pair("y", &rail.y), std::pair("z", &rail.z), std::pair("roll", &rail.roll),
                 std::pair("y_velocity", &rail.y_velocity), std::pair("z_velocity", &rail.z_velocity),
                 std::pair("roll_velocity", &rail.roll_velocity), std::pair("Fy", &rail.Fy), std::pair("Fz", &rail.Fz));
}

}  // namespace

json encode_wheel_rail_state(const WheelRailState& state) {
    json result = object({{"position", encode_numbers(numbers_of_position(state.position))},
                          {"velocity", encode_numbers(numbers_of_velocity(state.velocity))},
                          {"rail", encode_numbers(numbers_of_rail(state.rail))},
                          {"roller_pitch", finite(state.roller_pitch, "roller_pitch")}});
    if (state.Fz) result["Fz"] = finite(*state.Fz, "Fz");
    if (state.Fx) result["Fx"] = finite(*state.Fx, "Fx");
    if (state.derivatives) result["derivatives"] = true;
    return result;
}

WheelRailState decode_wheel_rail_state(const json& source) {
    WheelRailState state;
    const auto has = [&](const char* field) { return source.contains(field); };
    if (has("position")) decode_numbers(source["position"], numbers_of_position(state.position));
    if (has("velocity")) decode_numbers(source["velocity"], numbers_of_velocity(state.velocity));
    if (has("rail")) decode_numbers(source["rail"], numbers_of_rail(state.rail));
    if (has("roller_pitch")) state.roller_pitch = source["roller_pitch"].get<double>();
    if (has("Fz")) state.Fz = source["Fz"].get<double>();
    if (has("Fx")) state.Fx = source["Fx"].get<double>();
    state.derivatives = source.value("derivatives", false);
    return state;
}

json encode_wheelset_state(const WheelsetState& state) {
    return object({{"position", encode_numbers(numbers_of_position(state.position))},
                   {"velocity", encode_numbers(numbers_of_velocity(state.velocity))},
                   {"left_rail", encode_numbers(numbers_of_rail(state.left_rail))},
                   {"right_rail", encode_numbers(numbers_of_rail(state.right_rail))},
                   {"roller_pitch", finite(state.roller_pitch, "roller_pitch")},
                   {"Fz_left", finite(state.Fz_left, "Fz_left")},
                   {"Fz_right", finite(state.Fz_right, "Fz_right")}});
}

WheelsetState decode_wheelset_state(const json& source) {
    WheelsetState state;
    const auto has = [&](const char* field) { return source.contains(field); };
    if (has("position")) decode_numbers(source["position"], numbers_of_position(state.position));
    if (has("velocity")) decode_numbers(source["velocity"], numbers_of_velocity(state.velocity));
    if (has("left_rail")) decode_numbers(source["left_rail"], numbers_of_rail(state.left_rail));
    if (has("right_rail")) decode_numbers(source["right_rail"], numbers_of_rail(state.right_rail));
    state.roller_pitch = source.value("roller_pitch", 0.0);
    state.Fz_left = source["Fz_left"].get<double>();
    state.Fz_right = source["Fz_right"].get<double>();
    return state;
}

}  // namespace contactd::proto

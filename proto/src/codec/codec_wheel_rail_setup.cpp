// Encodes and decodes `setup` of wheelrail.*.
#include <span>

#include "codec_parts.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_setup(const WheelRailSetup& setup, ArrayWriter& arrays, const char* name = "setup") {
    return write_fields(setup, MemberPath(name), {&arrays});
}

WheelRailSetup decode_setup(const json& params, const char* name, const Frames& frames) {
    WheelRailSetup setup;
    if (params.contains(name)) read_fields(params[name], setup, MemberPath(name), {frames});
    return setup;
}

json encode_setups(const WheelsetSetup& wheelset, ArrayWriter& arrays) {
    json result = object({{"setup", encode_setup(wheelset.setup, arrays)}});
    if (wheelset.left) result["left"] = encode_setup(*wheelset.left, arrays, "left");
    return result;
}

void add_fields(const PatchFields& fields, json& params) {
    if (fields.solution != all_solution_fields) params["fields"] = encode_fields(fields.solution);
    if (fields.gap) params["gap"] = true;
}

}  // namespace

json encode_wheel_rail_setup(const WheelRailSetup& setup, ArrayWriter& arrays) {
    return encode_setup(setup, arrays);
}

json encode_wheel_rail_friction(const WheelRailFriction& friction) {
    return write_fields(friction, MemberPath("friction"));
}

WheelRailFriction decode_wheel_rail_friction(const json& source) {
    WheelRailFriction friction;
    read_fields(source, friction, MemberPath("friction"));
    return friction;
}

json encode_wheel_rail_request(const WheelRailSetup& setup, const WheelRailState& state, const PatchFields& fields,
                               ArrayWriter& arrays) {
    json params = object({{"setup", encode_setup(setup, arrays)}, {"state", write_fields(state, MemberPath("state"))}});
    add_fields(fields, params);
    return params;
}

json encode_wheelset_request(const WheelsetSetup& setup, const WheelsetState& state, const PatchFields& fields,
                             ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["state"] = write_fields(state, MemberPath("state"));
    add_fields(fields, params);
    return params;
}

json encode_geometry_request(const WheelRailSetup& setup, std::span<const WheelRailState> states, ArrayWriter& arrays) {
    json params = object({{"setup", encode_setup(setup, arrays)}, {"states", json::array()}});
    for (const WheelRailState& state : states) params["states"].push_back(write_fields(state, MemberPath("state")));
    return params;
}

json encode_conicity_request(const WheelsetSetup& setup, const ConicityRequest& requested, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["conicity"] = write_fields(requested, MemberPath("conicity"));
    return params;
}

json encode_contacts_request(const WheelsetSetup& setup, const ContactsRequest& requested, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["contacts"] = write_fields(requested, MemberPath("contacts"));
    return params;
}

json encode_profiles_request(const WheelsetSetup& setup, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["profiles"] = true;
    return params;
}

PatchFields decode_patch_fields(const json& params) {
    return {decode_fields(params, all_solution_fields), params.value("gap", false)};
}

WheelRailSetup decode_wheel_rail_setup(const json& params, const Frames& frames) {
    return decode_setup(params, "setup", frames);
}

WheelsetSetup decode_wheelset_setup(const json& params, const Frames& frames) {
    WheelsetSetup setup{decode_setup(params, "setup", frames)};
    if (params.contains("left")) setup.left = decode_setup(params, "left", frames);
    return setup;
}

}  // namespace contactd::proto

// Encodes and decodes contact.temperature.
#include "codec_parts.hpp"
#include "contactd/fields/temperature.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

template <class Request>
auto arrays_of(Request& request) {
    return std::array{std::pair("pressure", &request.pressure), std::pair("traction_x", &request.traction_x),
                      std::pair("traction_y", &request.traction_y), std::pair("slip_x", &request.slip_x),
                      std::pair("slip_y", &request.slip_y)};
}

/// Returns the optional arrays.
template <class Request>
auto optional_arrays_of(Request& request) {
    return std::array{std::pair("flow_x", &request.flow_x), std::pair("flow_y", &request.flow_y)};
}

template <class Temperatures>
auto arrays_of_answer(Temperatures& temperatures) {
    return std::array{std::pair("upper_temperature", &temperatures.upper_temperature),
                      std::pair("lower_temperature", &temperatures.lower_temperature)};
}

}  // namespace

json encode_temperature_request(const TemperatureRequest& request, ArrayWriter& arrays) {
    json params{{"grid", encode_grid(request.grid)},
                {"temperature", write_fields(request.temperature, MemberPath("temperature"))},
                {"velocity", finite_field(request.velocity, "velocity")},
                {"chi", finite_field(request.chi, "chi")}};
    if (request.upper_speed) params["upper_speed"] = finite_field(*request.upper_speed, "upper_speed");
    for (const auto& [name, values] : arrays_of(request))
        params[name] = arrays.write(std::span<const double>(*values), shape_of(request.grid));
    for (const auto& [name, values] : optional_arrays_of(request))
        if (!values->empty()) params[name] = arrays.write(std::span<const double>(*values), shape_of(request.grid));
    return params;
}

TemperatureRequest decode_temperature_request(const json& params, const Frames& frames) {
    TemperatureRequest request;
    request.grid = decode_grid(params["grid"]);
    if (params.contains("temperature"))
        read_fields(params["temperature"], request.temperature, MemberPath("temperature"));
    request.velocity = params["velocity"].get<double>();
    request.chi = params.value("chi", 0.0);
    if (params.contains("upper_speed")) request.upper_speed = params["upper_speed"].get<double>();
    for (const auto& [name, values] : arrays_of(request))
        *values = read_array(params[name], frames, shape_of(request.grid), name);
    for (const auto& [name, values] : optional_arrays_of(request))
        if (params.contains(name)) *values = read_array(params[name], frames, shape_of(request.grid), name);
    return request;
}

json encode_temperature_reply(const SurfaceTemperatures& reply, const Grid& grid, ArrayWriter& arrays) {
    json result{{"temperature", write_answer(reply.temperature, MemberPath("temperature"))},
                {"warnings", reply.warnings}};
    for (const auto& [name, values] : arrays_of_answer(reply))
        result[name] = arrays.write(std::span<const double>(*values), shape_of(grid));
    return result;
}

SurfaceTemperatures decode_temperature_reply(const json& result, const Grid& grid, const Frames& frames) {
    SurfaceTemperatures reply;
    read_fields(result["temperature"], reply.temperature, MemberPath("temperature"));
    reply.warnings = result["warnings"].get<std::vector<std::string>>();
    for (const auto& [name, values] : arrays_of_answer(reply))
        *values = read_array(result[name], frames, shape_of(grid), name);
    return reply;
}

}  // namespace contactd::proto

// Derivatives of a solution: an object of each answer with a number for each input.
#include <array>
#include <optional>
#include <utility>

#include "codec_parts.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

/// Derivatives may be const.
template <class Derivatives>
auto answers_of(Derivatives& derivatives) {
    return std::array{std::pair("Fx", &derivatives.Fx), std::pair("Fy", &derivatives.Fy),
                      std::pair("Mz", &derivatives.Mz), std::pair("Fn", &derivatives.Fn),
                      std::pair("approach", &derivatives.approach)};
}

template <class Row>
auto inputs_of(Row& row) {
    return std::array{std::pair("xi", &row.xi),   std::pair("eta", &row.eta),
                      std::pair("phi", &row.phi), std::pair("rotation", &row.rotation),
                      std::pair("Fn", &row.Fn),   std::pair("approach", &row.approach),
                      std::pair("mu", &row.mu)};
}

json encode_row(const DerivativesOfAnswer& row) {
    json result = json::object();
    for (const auto& [name, value] : inputs_of(row))
        if (*value) result[name] = finite(**value, "A derivative");
    if (row.rigid_shift)
        result["rigid_shift"] = {finite(row.rigid_shift->x, "A derivative"),
                                 finite(row.rigid_shift->y, "A derivative")};
    return result;
}

DerivativesOfAnswer decode_row(const json& source) {
    DerivativesOfAnswer row;
    for (const auto& [name, value] : inputs_of(row))
        if (source.contains(name)) *value = source[name].get<double>();
    if (source.contains("rigid_shift"))
        row.rigid_shift =
            DerivativesByShift{source["rigid_shift"][0].get<double>(), source["rigid_shift"][1].get<double>()};
    return row;
}

}  // namespace

json encode_derivatives(const Derivatives& derivatives) {
    json result = json::object();
    for (const auto& [name, row] : answers_of(derivatives))
        if (*row) result[name] = encode_row(**row);
    return result;
}

Derivatives decode_derivatives(const json& source) {
    Derivatives derivatives;
    for (const auto& [name, row] : answers_of(derivatives))
        if (source.contains(name)) *row = decode_row(source[name]);
    return derivatives;
}

}  // namespace contactd::proto

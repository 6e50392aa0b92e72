// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/derivatives.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const Derivatives& all) {
    [[maybe_unused]] const auto& [Fx_, Fy_, Mz_, Fn_, approach_] = all;
}
[[maybe_unused]] void all_of(const DerivativesOfAnswer& all) {
    [[maybe_unused]] const auto& [xi_, eta_, phi_, rigid_shift_, rotation_, approach_, Fn_, mu_] = all;
}
[[maybe_unused]] void all_of(const DerivativesByShift& all) {
    [[maybe_unused]] const auto& [x_, y_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Derivatives>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Derivatives::Fx>("Fx"),
        fields::field<&Derivatives::Fy>("Fy"),
        fields::field<&Derivatives::Mz>("Mz"),
        fields::field<&Derivatives::Fn>("Fn"),
        fields::field<&Derivatives::approach>("approach"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<DerivativesOfAnswer>() {
    static const auto list = std::to_array<Field>({
        fields::field<&DerivativesOfAnswer::xi>("xi"),
        fields::field<&DerivativesOfAnswer::eta>("eta"),
        fields::field<&DerivativesOfAnswer::phi>("phi"),
        fields::field<&DerivativesOfAnswer::rigid_shift>("rigid_shift"),
        fields::field<&DerivativesOfAnswer::rotation>("rotation"),
        fields::field<&DerivativesOfAnswer::approach>("approach"),
        fields::field<&DerivativesOfAnswer::Fn>("Fn"),
        fields::field<&DerivativesOfAnswer::mu>("mu"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<DerivativesByShift>() {
    static const auto list = std::to_array<Field>({
        fields::field<&DerivativesByShift::x>("x"),
        fields::field<&DerivativesByShift::y>("y"),
    });
    static const FieldType type = fields::tuple_type(list);
    return type;
}

}  // namespace contactd

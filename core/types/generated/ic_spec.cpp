// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/ic_spec.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const LineContactSpec& all) {
    [[maybe_unused]] const auto& [datum_] = all;
}
[[maybe_unused]] void all_of(const FemSpec& all) {
    [[maybe_unused]] const auto& [mesh_, order_, l_over_h_, h_over_hs_, f_, t1_over_hs_, L_over_h_, diagonal_,
                                  max_dofs_, far_boundary_, sampling_, solver_, stopping_criterion_, tolerance_,
                                  max_iterations_, strength_threshold_] = all;
}

}  // namespace

template <>
const FieldType& type_of<Ics>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<Ics, &Ics::source>("source", {.required = true}),
        fields::field_along<Ics, &Ics::body>("body"),
        fields::field_along<Ics, &Ics::load_shape>("load_shape"),
        fields::custom_field_along<Ics, &Ics::section>("section"),
        fields::field_along<Ics, &Ics::layered, &Layers::layers>("layers"),
        fields::custom_field_along<Ics, &Ics::layered, &Layers::base>("base"),
        fields::field_along<Ics, &Ics::line_contact>("line_contact"),
        fields::field_along<Ics, &Ics::accuracy>("accuracy", {.bounds = {.least = 0.0001, .most = 0.1}, .none = 0}),
        fields::field_along<Ics, &Ics::any_nu>("any_nu"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::mesh>("mesh"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::order>("order", {.bounds = {.least = 1, .most = 6}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::l_over_h>("l_over_h", {.bounds = {.least = 0.5, .most = 64}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::h_over_hs>("h_over_hs", {.bounds = {.least = 2, .most = 128}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::f>("f", {.bounds = {.least = 1, .most = 10}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::t1_over_hs>("t1_over_hs", {.bounds = {.least = 0, .most = 1000}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::L_over_h>(
            "L_over_h", {.bounds = {.least = 0, .most = 1e+09, .least_excluded = true}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::diagonal>("diagonal"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::max_dofs>("max_dofs", {.bounds = {.least = 1000, .most = 5e+06}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::far_boundary>("far_boundary"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::sampling>("sampling"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::solver>("solver"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::stopping_criterion>("stopping_criterion"),
        fields::field_along<Ics, &Ics::fem, &FemSpec::tolerance>(
            "tolerance", {.bounds = {.least = 1e-13, .most = 1, .most_excluded = true}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::max_iterations>("max_iterations",
                                                                      {.bounds = {.least = 1, .most = 1e+06}}),
        fields::field_along<Ics, &Ics::fem, &FemSpec::strength_threshold>(
            "strength_threshold", {.bounds = {.least = 0, .most = 1, .most_excluded = true}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<LineContactSpec>() {
    static const auto list = std::to_array<Field>({
        fields::field<&LineContactSpec::datum>(
            "datum", {.bounds = {.least = 0, .most = 1e+12, .least_excluded = true}, .unit = "mm", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<FemSpec>() {
    static const auto list = std::to_array<Field>({
        fields::field<&FemSpec::mesh>("mesh"),
        fields::field<&FemSpec::order>("order", {.bounds = {.least = 1, .most = 6}}),
        fields::field<&FemSpec::l_over_h>("l_over_h", {.bounds = {.least = 0.5, .most = 64}}),
        fields::field<&FemSpec::h_over_hs>("h_over_hs", {.bounds = {.least = 2, .most = 128}}),
        fields::field<&FemSpec::f>("f", {.bounds = {.least = 1, .most = 10}}),
        fields::field<&FemSpec::t1_over_hs>("t1_over_hs", {.bounds = {.least = 0, .most = 1000}}),
        fields::field<&FemSpec::L_over_h>("L_over_h", {.bounds = {.least = 0, .most = 1e+09, .least_excluded = true}}),
        fields::field<&FemSpec::diagonal>("diagonal"),
        fields::field<&FemSpec::max_dofs>("max_dofs", {.bounds = {.least = 1000, .most = 5e+06}}),
        fields::field<&FemSpec::far_boundary>("far_boundary"),
        fields::field<&FemSpec::sampling>("sampling"),
        fields::field<&FemSpec::solver>("solver"),
        fields::field<&FemSpec::stopping_criterion>("stopping_criterion"),
        fields::field<&FemSpec::tolerance>("tolerance", {.bounds = {.least = 1e-13, .most = 1, .most_excluded = true}}),
        fields::field<&FemSpec::max_iterations>("max_iterations", {.bounds = {.least = 1, .most = 1e+06}}),
        fields::field<&FemSpec::strength_threshold>("strength_threshold",
                                                    {.bounds = {.least = 0, .most = 1, .most_excluded = true}}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/contact.hpp"

#include <array>

namespace contactd {
namespace {

// A member that the schema does not declare makes the number of these names wrong.
[[maybe_unused]] void all_of(const ContactSolution& all) {
    [[maybe_unused]] const auto& [approach_, forces_, resultant_, pmax_, area_, elements_, element_division_, pressure_,
                                  traction_x_, traction_y_, slip_x_, slip_y_, flow_x_, flow_y_, yield_stress_,
                                  friction_coefficient_, displacement_x_, displacement_y_, displacement_z_,
                                  upper_temperature_, lower_temperature_, pressure_by_approach_, temperature_, wear_,
                                  fatigue_, rolling_resistance_, elastic_energy_, frictional_work_, frictional_power_,
                                  plastic_work_, plastic_power_, largest_flow_, motion_, upper_speed_, derivatives_,
                                  warnings_, evidence_] = all;
}
[[maybe_unused]] void all_of(const Forces& all) {
    [[maybe_unused]] const auto& [Fn_, Fx_, Fy_, Mz_] = all;
}
[[maybe_unused]] void all_of(const Areas& all) {
    [[maybe_unused]] const auto& [contact_, adhesion_, slip_, flow_] = all;
}
[[maybe_unused]] void all_of(const Counts& all) {
    [[maybe_unused]] const auto& [contact_, adhesion_, slip_, flow_, border_] = all;
}
[[maybe_unused]] void all_of(const ContactEvidence& all) {
    [[maybe_unused]] const auto& [normal_, tangential_, outer_, force_, discretisation_, derivatives_, accuracy_,
                                  tangential_solver_] = all;
}
[[maybe_unused]] void all_of(const Discretisation& all) {
    [[maybe_unused]] const auto& [elements_across_, force_error_, pmax_error_, source_, rolling_error_,
                                  compliance_ratio_] = all;
}
[[maybe_unused]] void all_of(const ForceAccuracy& all) {
    [[maybe_unused]] const auto& [coarse_, fine_, force_error_, moment_error_, converged_] = all;
}
[[maybe_unused]] void all_of(const GridForces& all) {
    [[maybe_unused]] const auto& [nx_, ny_, Fx_, Fy_, Mz_] = all;
}
[[maybe_unused]] void all_of(const RollingResistance& all) {
    [[maybe_unused]] const auto& [force_, power_, centre_of_pressure_, moment_, defect_] = all;
}
[[maybe_unused]] void all_of(const SolverEvidence& all) {
    [[maybe_unused]] const auto& [iterations_, residual_, converged_, seconds_] = all;
}

}  // namespace

template <>
const FieldType& type_of<ContactProblem>() {
    static const auto list = std::to_array<Field>({
        fields::field_along<ContactProblem, &ContactProblem::grid>("grid", {.required = true}),
        fields::field_along<ContactProblem, &ContactProblem::gap>("gap", {.required = true}),
        fields::field_along<ContactProblem, &ContactProblem::approach>(
            "approach", {.bounds = {.least = -1e+12, .most = 1e+12}, .unit = "mm"}),
        fields::field_along<ContactProblem, &ContactProblem::Fn>("Fn",
                                                                 {.bounds = {.least = 0, .most = 1e+18}, .unit = "N"}),
        fields::field_along<ContactProblem, &ContactProblem::model>("model"),
        fields::field_along<ContactProblem, &ContactProblem::normal_model>("normal_model"),
        fields::field_along<ContactProblem, &ContactProblem::simplified>("simplified"),
        fields::field_along<ContactProblem, &ContactProblem::sheet_flexibility>(
            "sheet_flexibility", {.bounds = {.least = 0, .most = 1e+06}, .unit = "mm^3/N"}),
        fields::field_along<ContactProblem, &ContactProblem::temperature>("temperature"),
        fields::field_along<ContactProblem, &ContactProblem::wear>("wear"),
        fields::field_along<ContactProblem, &ContactProblem::fatigue>("fatigue"),
        fields::field_beside<ContactProblem, &ContactProblem::friction>("friction",
                                                                        &type_of<FrictionFields<ContactProblem>>),
        fields::field_along<ContactProblem, &ContactProblem::previous>("previous"),
        fields::field_along<ContactProblem, &ContactProblem::columns>("columns"),
        fields::field_along<ContactProblem, &ContactProblem::regions>("regions"),
        fields::field_along<ContactProblem, &ContactProblem::accuracy>("accuracy",
                                                                       {.bounds = {.least = 0.0003, .most = 0.1}}),
        fields::field_along<ContactProblem, &ContactProblem::settings>("settings"),
        fields::field_along<ContactProblem, &ContactProblem::initial>("initial"),
        fields::field_along<ContactProblem, &ContactProblem::derivatives>("derivatives"),
        fields::field_along<ContactProblem, &ContactProblem::displacements>("displacements"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactSolution>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactSolution::approach>("approach", {.unit = "mm", .required = true}),
        fields::field<&ContactSolution::forces>("forces", {.required = true}),
        fields::field<&ContactSolution::resultant>("resultant"),
        fields::field<&ContactSolution::pmax>("pmax", {.bounds = {.least = 0}, .unit = "N/mm^2", .required = true}),
        fields::field<&ContactSolution::area>("area", {.required = true}),
        fields::field<&ContactSolution::elements>("elements", {.required = true}),
        fields::custom_field<&ContactSolution::element_division>("element_division"),
        fields::custom_field<&ContactSolution::pressure>("pressure"),
        fields::custom_field<&ContactSolution::traction_x>("traction_x"),
        fields::custom_field<&ContactSolution::traction_y>("traction_y", {.parity = MirrorParity::odd}),
        fields::custom_field<&ContactSolution::slip_x>("slip_x"),
        fields::custom_field<&ContactSolution::slip_y>("slip_y", {.parity = MirrorParity::odd}),
        fields::custom_field<&ContactSolution::flow_x>("flow_x"),
        fields::custom_field<&ContactSolution::flow_y>("flow_y", {.parity = MirrorParity::odd}),
        fields::custom_field<&ContactSolution::yield_stress>("yield_stress"),
        fields::custom_field<&ContactSolution::friction_coefficient>("friction_coefficient"),
        fields::custom_field<&ContactSolution::displacement_x>("displacement_x"),
        fields::custom_field<&ContactSolution::displacement_y>("displacement_y", {.parity = MirrorParity::odd}),
        fields::custom_field<&ContactSolution::displacement_z>("displacement_z"),
        fields::custom_field<&ContactSolution::upper_temperature>("upper_temperature"),
        fields::custom_field<&ContactSolution::lower_temperature>("lower_temperature"),
        fields::custom_field<&ContactSolution::pressure_by_approach>("pressure_by_approach"),
        fields::field<&ContactSolution::temperature>("temperature"),
        fields::field<&ContactSolution::wear>("wear"),
        fields::field<&ContactSolution::fatigue>("fatigue"),
        fields::field<&ContactSolution::rolling_resistance>("rolling_resistance"),
        fields::field<&ContactSolution::elastic_energy>("elastic_energy", {.unit = "N mm"}),
        fields::field<&ContactSolution::frictional_work>("frictional_work", {.unit = "N mm"}),
        fields::field<&ContactSolution::frictional_power>("frictional_power", {.unit = "N mm/s"}),
        fields::field<&ContactSolution::plastic_work>("plastic_work", {.unit = "N mm"}),
        fields::field<&ContactSolution::plastic_power>("plastic_power", {.unit = "N mm/s"}),
        fields::field<&ContactSolution::largest_flow>("largest_flow", {.bounds = {.least = 0}}),
        fields::custom_field<&ContactSolution::motion>("motion"),
        fields::field<&ContactSolution::upper_speed>("upper_speed", {.bounds = {.least = 0}, .unit = "mm/s"}),
        fields::field<&ContactSolution::derivatives>("derivatives"),
        fields::field<&ContactSolution::warnings>("warnings", {.required = true}),
        fields::field<&ContactSolution::evidence>("evidence", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Forces>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Forces::Fn>("Fn", {.unit = "N", .required = true}),
        fields::field<&Forces::Fx>("Fx", {.unit = "N", .required = true}),
        fields::field<&Forces::Fy>("Fy", {.unit = "N", .parity = MirrorParity::odd, .required = true}),
        fields::field<&Forces::Mz>("Mz", {.unit = "N mm", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Areas>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Areas::contact>("contact", {.bounds = {.least = 0}, .unit = "mm^2", .required = true}),
        fields::field<&Areas::adhesion>("adhesion", {.bounds = {.least = 0}, .unit = "mm^2", .required = true}),
        fields::field<&Areas::slip>("slip", {.bounds = {.least = 0}, .unit = "mm^2", .required = true}),
        fields::field<&Areas::flow>("flow", {.bounds = {.least = 0}, .unit = "mm^2"}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Counts>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Counts::contact>("contact", {.bounds = {.least = 0}, .required = true}),
        fields::field<&Counts::adhesion>("adhesion", {.bounds = {.least = 0}, .required = true}),
        fields::field<&Counts::slip>("slip", {.bounds = {.least = 0}, .required = true}),
        fields::field<&Counts::flow>("flow", {.bounds = {.least = 0}}),
        fields::field<&Counts::border>("border", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ContactEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ContactEvidence::normal>("normal", {.required = true}),
        fields::field<&ContactEvidence::tangential>("tangential"),
        fields::field<&ContactEvidence::outer>("outer"),
        fields::field<&ContactEvidence::force>("force"),
        fields::field<&ContactEvidence::discretisation>("discretisation"),
        fields::field<&ContactEvidence::derivatives>("derivatives"),
        fields::field<&ContactEvidence::accuracy>("accuracy"),
        fields::field<&ContactEvidence::tangential_solver>("tangential_solver"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<Discretisation>() {
    static const auto list = std::to_array<Field>({
        fields::field<&Discretisation::elements_across>("elements_across", {.bounds = {.least = 1}, .required = true}),
        fields::field<&Discretisation::force_error>("force_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&Discretisation::pmax_error>("pmax_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&Discretisation::source>("source", {.required = true}),
        fields::field<&Discretisation::rolling_error>("rolling_error", {.bounds = {.least = 0}}),
        fields::field<&Discretisation::compliance_ratio>("compliance_ratio"),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<ForceAccuracy>() {
    static const auto list = std::to_array<Field>({
        fields::field<&ForceAccuracy::coarse>("coarse", {.required = true}),
        fields::field<&ForceAccuracy::fine>("fine", {.required = true}),
        fields::field<&ForceAccuracy::force_error>("force_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&ForceAccuracy::moment_error>("moment_error", {.bounds = {.least = 0}, .required = true}),
        fields::field<&ForceAccuracy::converged>("converged", {.required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<GridForces>() {
    static const auto list = std::to_array<Field>({
        fields::field<&GridForces::nx>("nx", {.bounds = {.least = 1}, .required = true}),
        fields::field<&GridForces::ny>("ny", {.bounds = {.least = 1}, .required = true}),
        fields::field<&GridForces::Fx>("Fx", {.unit = "N", .required = true}),
        fields::field<&GridForces::Fy>("Fy", {.unit = "N", .parity = MirrorParity::odd, .required = true}),
        fields::field<&GridForces::Mz>("Mz", {.unit = "N mm", .parity = MirrorParity::odd, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<RollingResistance>() {
    static const auto list = std::to_array<Field>({
        fields::field<&RollingResistance::force>("force", {.unit = "N", .required = true}),
        fields::field<&RollingResistance::power>("power", {.unit = "N mm/s", .required = true}),
        fields::field<&RollingResistance::centre_of_pressure>("centre_of_pressure", {.unit = "mm", .required = true}),
        fields::field<&RollingResistance::moment>("moment", {.unit = "N mm", .required = true}),
        fields::field<&RollingResistance::defect>("defect", {.bounds = {.least = 0}, .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

template <>
const FieldType& type_of<SolverEvidence>() {
    static const auto list = std::to_array<Field>({
        fields::field<&SolverEvidence::iterations>("iterations", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SolverEvidence::residual>("residual", {.bounds = {.least = 0}, .required = true}),
        fields::field<&SolverEvidence::converged>("converged", {.required = true}),
        fields::field<&SolverEvidence::seconds>("seconds", {.bounds = {.least = 0}, .unit = "s", .required = true}),
    });
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace contactd

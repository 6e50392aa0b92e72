// Reads and writes the group `evidence`: the origin and the accuracy of a table.
#include <array>
#include <optional>
#include <string>

#include "contents_parts.hpp"

namespace contactd {
namespace {

struct ErrorName {
    const char* origin;
    const char* largest;
    std::optional<ComponentError> IcErrors::* member;
};
constexpr std::array<ErrorName, 3> error_names{{{"error_xx_origin", "error_xx_largest", &IcErrors::xx},
                                                {"error_yy_origin", "error_yy_largest", &IcErrors::yy},
                                                {"error_zz_origin", "error_zz_largest", &IcErrors::zz}}};

Axis axis(const Group& at) {
    const int number = integer(at, "load_axis");
    if (number < static_cast<int>(Axis::x) || number > static_cast<int>(Axis::z))
        throw DamagedTable("The load axis " + std::to_string(number) + " of the file is invalid.");
    return static_cast<Axis>(number);
}

}  // namespace

void write_evidence(const WritableGroup& group, const IcEvidence& evidence) {
    put(group, "source", evidence.source);
    put(group, "version", evidence.version);
    put(group, "elements", evidence.elements);
    put(group, "dofs", evidence.dofs);
    put(group, "processes", static_cast<long long>(evidence.processes));
    put(group, "assembly_seconds", evidence.seconds.assembly);
    put(group, "setup_seconds", evidence.seconds.setup);
    put(group, "solve_seconds", evidence.seconds.solve);
    put(group, "total_seconds", evidence.seconds.total);
    if (!evidence.solver.empty()) put(group, "solver", evidence.solver);
    put(group, "warnings", evidence.warnings);
    put(group, "errors_estimated", static_cast<long long>(evidence.errors_estimated));
    put(group, "family_nu", evidence.family_nu);
    if (evidence.interpolation_error) put(group, "interpolation_error", *evidence.interpolation_error);
    if (evidence.modelling_error) put(group, "modelling_error", *evidence.modelling_error);
    if (const auto& section = evidence.section) {
        put(group, "section_order", section->order);
        put(group, "wavenumbers", section->wavenumbers);
        put(group, "section_error", section->error);
        put(group, "mesh_error", section->mesh_error);
        put(group, "wavenumber_error", section->wavenumber_error);
        put(group, "end_error", section->end_error);
        put(group, "reciprocity_defect", section->reciprocity_defect);
    }
    if (evidence.imported) put(group, "imported", 1);
    if (evidence.mesh) write_fem(group.below("mesh"), *evidence.mesh);
    for (const ErrorName& name : error_names)
        if (const auto& error = evidence.errors.*name.member) {
            put(group, name.origin, error->origin);
            put(group, name.largest, error->largest);
        }
    if (evidence.errors.scaled_xy) put(group, "scaled_error_xy", *evidence.errors.scaled_xy);
    if (evidence.errors.scaled_xz) put(group, "scaled_error_xz", *evidence.errors.scaled_xz);
    for (std::size_t n = 0; n < evidence.load_cases.size(); ++n) {
        const LoadCaseEvidence& load_case = evidence.load_cases[n];
        const WritableGroup at = group.below("load_case_" + std::to_string(n));
        put(at, "load_axis", static_cast<long long>(load_case.load));
        put(at, "iterations", static_cast<long long>(load_case.iterations));
        put(at, "residual", load_case.residual);
        put(at, "converged", static_cast<long long>(load_case.converged));
        put(at, "seconds", load_case.seconds);
        if (load_case.update) put(at, "update", *load_case.update);
    }
}

IcEvidence read_evidence(const Group& group) {
    IcEvidence evidence;
    evidence.source = text(group, "source");
    evidence.version = text(group, "version");
    evidence.elements = long_integer(group, "elements");
    evidence.dofs = long_integer(group, "dofs");
    evidence.processes = integer(group, "processes");
    evidence.seconds.assembly = number(group, "assembly_seconds");
    evidence.seconds.setup = number(group, "setup_seconds");
    evidence.seconds.solve = number(group, "solve_seconds");
    evidence.seconds.total = number(group, "total_seconds");
    if (group.has("solver")) evidence.solver = text(group, "solver");
    evidence.warnings = texts(group, "warnings");
    evidence.errors_estimated = integer(group, "errors_estimated") != 0;
    evidence.family_nu = numbers(group, "family_nu");
    if (group.has("interpolation_error")) evidence.interpolation_error = number(group, "interpolation_error");
    if (group.has("modelling_error")) evidence.modelling_error = number(group, "modelling_error");
    if (group.has("section_order"))
        evidence.section = {integer(group, "section_order"),    integer(group, "wavenumbers"),
                            number(group, "section_error"),     number(group, "mesh_error"),
                            number(group, "wavenumber_error"),  number(group, "end_error"),
                            number(group, "reciprocity_defect")};
    if (group.has("imported")) evidence.imported = integer(group, "imported") != 0;
    if (group.has_group("mesh")) evidence.mesh = read_fem(group.below("mesh"));
    for (const ErrorName& name : error_names)
        if (group.has(name.origin))
            evidence.errors.*name.member = ComponentError{number(group, name.origin), number(group, name.largest)};
    if (group.has("scaled_error_xy")) evidence.errors.scaled_xy = number(group, "scaled_error_xy");
    if (group.has("scaled_error_xz")) evidence.errors.scaled_xz = number(group, "scaled_error_xz");
    for (int n = 0; group.has_group("load_case_" + std::to_string(n)); ++n) {
        const Group at = group.below("load_case_" + std::to_string(n));
        LoadCaseEvidence load_case{axis(at),
                                   integer(at, "iterations"),
                                   number(at, "residual"),
                                   integer(at, "converged") != 0,
                                   number(at, "seconds"),
                                   {}};
        if (at.has("update")) load_case.update = number(at, "update");
        evidence.load_cases.push_back(load_case);
    }
    return evidence;
}

}  // namespace contactd

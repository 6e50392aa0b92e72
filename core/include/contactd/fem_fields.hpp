// This is the only list of the fields of a FemSpec. The wire, files, keys and checks visit it.
#pragma once

#include <limits>
#include <tuple>

#include "contactd/ic_spec.hpp"

namespace contactd {

/// Holds the bounds of a number, and `rule` in words: "be 1 to 6".
struct FemRange {
    double least = -std::numeric_limits<double>::infinity();
    double largest = std::numeric_limits<double>::infinity();
    const char* rule = nullptr;
};

/// Describes a field. A new field must be optional, and is omitted from messages, files and keys while unset, so that
/// existing tables keep their keys and can be read.
template <class Value>
struct FemField {
    const char* name;         ///< on the wire, below `ics`; in files; in keys
    Value FemSpec::* member;  ///< a number, an enum with keywords, or an optional number
    FemRange range{};
    /// Returns the violated rule other than bounds, or null. A rule for two fields belongs to one of
    /// them.
    const char* (*broken_rule)(const FemSpec& fem, LoadShape load) = nullptr;
    /// Returns whether a table with this mesh and solver depends on the field; null: always.
    bool (*matters)(const FemSpec& fem) = nullptr;
    /// Fields that only end a build or do not affect its numbers are not part of the key.
    bool in_key = true;
};

namespace fem_rules {

constexpr double below_one = 1 - 0x1p-53;

const char* l_over_h(const FemSpec& fem, LoadShape load);
const char* h_over_hs(const FemSpec& fem, LoadShape load);
const char* t1_over_hs(const FemSpec& fem, LoadShape load);
const char* L_over_h(const FemSpec& fem, LoadShape load);

constexpr bool is_prism(const FemSpec& fem) {
    return fem.mesh == MeshKind::prism;
}
constexpr bool is_adaptive(const FemSpec& fem) {
    return fem.mesh == MeshKind::adaptive;
}
/// An adaptive mesh starts from a built-in mesh, of which only the size can be set.
constexpr bool has_layers(const FemSpec& fem) {
    return !is_adaptive(fem);
}
constexpr bool may_iterate(const FemSpec& fem) {
    return fem.solver != Solver::direct;
}

}  // namespace fem_rules

/// The order is that of the struct and of the attributes in files.
inline constexpr std::tuple fem_fields{
    FemField<MeshKind>{.name = "mesh", .member = &FemSpec::mesh},
    FemField<int>{.name = "order", .member = &FemSpec::order, .range = {1, 6, "be 1 to 6"}},
    FemField<double>{
        .name = "l_over_h",
        .member = &FemSpec::l_over_h,
        .broken_rule = fem_rules::l_over_h,
        .matters = fem_rules::has_layers,
    },
    FemField<double>{
        .name = "h_over_hs",
        .member = &FemSpec::h_over_hs,
        .broken_rule = fem_rules::h_over_hs,
        .matters = fem_rules::has_layers,
    },
    FemField<double>{
        .name = "f",
        .member = &FemSpec::f,
        .range = {1, 10, "lie in [1, 10]"},
        .matters = fem_rules::has_layers,
    },
    FemField<double>{
        .name = "t1_over_hs",
        .member = &FemSpec::t1_over_hs,
        .broken_rule = fem_rules::t1_over_hs,
        .matters = fem_rules::has_layers,
    },
    FemField<double>{.name = "L_over_h", .member = &FemSpec::L_over_h, .broken_rule = fem_rules::L_over_h},
    FemField<Diagonal>{.name = "diagonal", .member = &FemSpec::diagonal, .matters = fem_rules::is_prism},
    FemField<long long>{
        .name = "max_dofs",
        .member = &FemSpec::max_dofs,
        .range = {1000, 5'000'000, "lie in [1000, 5000000]"},
        .matters = fem_rules::is_adaptive,
    },
    FemField<FarBoundary>{.name = "far_boundary", .member = &FemSpec::far_boundary},
    FemField<Sampling>{.name = "sampling", .member = &FemSpec::sampling},
    FemField<Solver>{.name = "solver", .member = &FemSpec::solver},
    FemField<StoppingCriterion>{
        .name = "stopping_criterion",
        .member = &FemSpec::stopping_criterion,
        .matters = fem_rules::may_iterate,
    },
    FemField<double>{
        .name = "tolerance",
        .member = &FemSpec::tolerance,
        .range = {1e-13, fem_rules::below_one, "lie in [1e-13, 1)"},
    },
    FemField<int>{
        .name = "max_iterations",
        .member = &FemSpec::max_iterations,
        .range = {.least = 1, .rule = "be at least 1"},
        .in_key = false,
    },
    FemField<std::optional<double>>{
        .name = "strength_threshold",
        .member = &FemSpec::strength_threshold,
        .range = {0, fem_rules::below_one, "lie in [0, 1)"},
        .matters = fem_rules::may_iterate,
    },
};

/// Calls `visit` with each field in turn.
template <class Visit>
void for_each_fem_field(Visit visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, fem_fields);
}

}  // namespace contactd

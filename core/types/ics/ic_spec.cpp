#include "contactd/ic_spec.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "block_spec.hpp"
#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fem_fields.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/grid.hpp"
#include "contactd/uniform_elements.hpp"
#include "types/ics/row_of_layers.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr long long max_elements = 200'000;              // some millions of unknowns, the capacity of one machine
constexpr std::size_t most_uniform_values = 50'000'000;  // limit of each of nine components: 3.6 GB in total
// The choice of meshes was tested up to this aspect ratio.
constexpr double largest_accuracy_aspect = 8;

void require(bool holds, const char* field, double value, const char* rule) {
    if (!holds) throw InvalidArgument(field, "is " + number_text(value) + "; it must " + rule);
}

[[noreturn]] void refuse(const char* name, double value, const char* rule) {
    throw InvalidArgument(std::string("ics.") + name, "is " + number_text(value) + "; it must " + rule);
}

void validate(const FemSpec& fem, LoadShape load) {
    for_each_fem_field([&]<class Value>(const FemField<Value>& field) {
        if constexpr (!HasWords<Value>) {
            const std::optional<double> value = fem.*field.member;
            if (!value) return;
            const bool inside = *value >= field.range.least && *value <= field.range.largest;
            if (field.range.rule && !inside) refuse(field.name, *value, field.range.rule);
            const char* broken = field.broken_rule ? field.broken_rule(fem, load) : nullptr;
            if (broken) refuse(field.name, *value, broken);
        }
    });
    if (fem.solver == Solver::direct && fem.mesh == MeshKind::adaptive)
        throw InvalidArgument(
            "ics.solver", "is direct, which does not support the hanging nodes of mesh adaptive; use amg_pcg or auto");
}

// Rows of elements are infinite in a line contact, so dy does not determine their shape.
void validate_line_contact(const IcSpec& spec) {
    if (spec.source != IcSource::analytic)
        throw InvalidArgument("ics.line_contact",
                              "requires source analytic; finite elements support three-dimensional bodies only");
    if (spec.ny != 1)
        throw InvalidArgument(
            "grid.ny", "is " + std::to_string(spec.ny) +
                           "; a line contact has one row of elements, and dy is the length that forces refer to");
    constexpr double rounding = 1e-9;
    const double datum = spec.line_contact->datum, length = spec.nx * spec.dx;
    if (!(std::isfinite(datum) && datum >= length * (1 - rounding)))
        throw InvalidArgument("ics.line_contact.datum",
                              "is " + number_text(datum) + "; it must be at least the length of the grid, " +
                                  number_text(length) + " mm, so that surfaces move in the direction of loads");
}

/// The closed form of constant loads is accurate to nine digits of the largest coefficient on elements a million times
/// as long as wide.
void validate_aspect(const IcSpec& spec) {
    const bool is_closed_form = spec.source == IcSource::analytic && spec.body == BodyShape::half_space &&
                                spec.load_shape == LoadShape::constant;
    const double aspect = spec.dx / spec.dy, most = is_closed_form ? 1e6 : 1e3;
    if (!(aspect >= 1 / most && aspect <= most))
        throw InvalidArgument("grid.dy",
                              "gives elements with dx/dy = " + number_text(aspect) +
                                  (is_closed_form ? "; it must lie in [1e-6, 1e6]" : "; it must lie in [0.001, 1000]") +
                                  ". Use ics.line_contact for a contact that does not change along y");
}

void validate_layers(const IcSpec& spec) {
    if (spec.body != BodyShape::layered)
        throw InvalidArgument("ics.layers", "require body layered, but body is " + std::string(name_of(spec.body)));
    if (!spec.layered) throw InvalidArgument("ics.layers", "is missing; body layered consists of layers on a base");
    validate(*spec.layered, spec.dx, "ics");
    if (spec.material != spec.layered->surface())
        throw InvalidArgument("material.G", "is " + number_text(spec.material.G) + ", with nu " +
                                                number_text(spec.material.nu) +
                                                "; give the material of the topmost layer, or remove it");
    if (spec.source != IcSource::analytic)
        throw InvalidArgument("ics.source", "is fem, but coefficients of layers are analytic: use analytic");
    if (spec.line_contact) throw InvalidArgument("ics.line_contact", row_of_layers);
}

void validate_uniform(const IcSpec& spec) {
    if (spec.body != BodyShape::longitudinally_uniform)
        throw InvalidArgument("ics.section",
                              "requires body longitudinally_uniform, but body is " + std::string(name_of(spec.body)));
    if (!spec.section)
        throw InvalidArgument("ics.section", "is missing; body longitudinally_uniform requires a cross-section");
    validate(*spec.section, "ics.section");
    if (spec.section->free)
        throw InvalidArgument(
            "ics.section.free",
            "is true, but the displacements of a body without clamped parts are undetermined: clamp a part of it");
    if (spec.ny > most_strips)
        throw InvalidArgument("grid.ny", "is " + std::to_string(spec.ny) +
                                             "; a longitudinally uniform body has at most " +
                                             std::to_string(most_strips) + " columns");
    // By finite elements, the record serves any nx; body_table limits the table of a request.
    if (spec.source == IcSource::analytic &&
        static_cast<std::size_t>(spec.nx) * static_cast<std::size_t>(spec.ny) * static_cast<std::size_t>(spec.ny) >
            most_uniform_values)
        throw InvalidArgument("grid.nx", "is " + std::to_string(spec.nx) + ", with ny " + std::to_string(spec.ny) +
                                             "; nx ny^2 of a longitudinally uniform body must not exceed " +
                                             std::to_string(most_uniform_values));
    if (spec.load_shape != LoadShape::constant)
        throw InvalidArgument(
            "ics.load_shape",
            "is bilinear, but longitudinally uniform bodies support constant tractions only: use constant");
    if (spec.line_contact)
        throw InvalidArgument("ics.line_contact",
                              "is available for half-spaces, not for longitudinally uniform bodies");
    if (spec.any_nu)
        throw InvalidArgument("ics.any_nu",
                              "is not available for a longitudinally uniform body, whose table is computed for one nu "
                              "in seconds: remove it");
    if (spec.source == IcSource::analytic) return;
    if (spec.accuracy == 0)
        throw InvalidArgument("ics.accuracy",
                              "is missing; the mesh of a longitudinally uniform body is chosen by the accuracy");
    constexpr double rounding = 1e-9;
    if (!(spec.dx >= shortest_uniform_element * spec.dy * (1 - rounding)))
        throw InvalidArgument("grid.dx", "is " + number_text(spec.dx) + ", " + short_text(spec.dx / spec.dy) +
                                             " of a column's width, dy; tables of longitudinally uniform bodies by "
                                             "finite elements require at least a half for their accuracy: use dy = " +
                                             number_text(spec.dx / shortest_uniform_element) + " mm or less");
}

void validate_body(const IcSpec& spec) {
    if (spec.body != BodyShape::block) return;
    if (spec.source == IcSource::analytic)
        throw InvalidArgument("ics.body", "is block, which has no closed form; use source fem");
    if (spec.accuracy == 0 && spec.fem.far_boundary != FarBoundary::clamped)
        throw InvalidArgument("ics.far_boundary", "is half_space, but the faces of a block are clamped: use clamped");
}

void validate_accuracy(const IcSpec& spec) {
    if (spec.source == IcSource::analytic)
        throw InvalidArgument("ics.accuracy", "requires source fem; the closed form is exact");
    require(spec.accuracy >= finest_accuracy && spec.accuracy <= coarsest_accuracy, "ics.accuracy", spec.accuracy,
            "lie in [0.0001, 0.1]");
    const double aspect = spec.dx / spec.dy;
    require(aspect >= 1 / largest_accuracy_aspect && aspect <= largest_accuracy_aspect, "ics.accuracy", spec.accuracy,
            "be replaced by mesh parameters if dx/dy is outside [0.125, 8]");
    if (spec.section)
        require(spec.material.nu <= largest_uniform_nu, "material.nu", spec.material.nu,
                "be at most 0.499 for a longitudinally uniform body by finite elements");
    else if (!spec.any_nu)
        require(spec.material.nu <= largest_family_nu, "material.nu", spec.material.nu,
                "be at most 0.49 if an accuracy is requested");
}

/// Up to these values, errors next to the load are below 1 % (docs/ic-tables.md).
double largest_nu(int order) {
    return order == 2 ? 0.49 : order == 3 ? 0.499 : 0.5;
}

}  // namespace

std::optional<FemSpec> fem_preset(std::string_view name) {
    FemSpec fem;
    fem.far_boundary = FarBoundary::clamped;
    fem.solver = Solver::amg_pcg;
    constexpr std::string_view mesh2 = "paper-mesh2-";
    std::string_view test = name;
    if (name.starts_with(mesh2)) {
        fem.mesh = MeshKind::prism;
        test.remove_prefix(mesh2.size());
    } else {
        constexpr std::string_view mesh1 = "paper-";
        if (!name.starts_with(mesh1)) return std::nullopt;
        test.remove_prefix(mesh1.size());
    }
    if (test == "test3") return fem;
    fem.f = 1.5;
    if (test == "test2") return fem;
    fem.l_over_h = 2.5;
    if (test == "test1") return fem;
    return std::nullopt;
}

void validate(const IcSpec& spec) {
    validate(Grid{spec.nx, spec.ny, spec.dx, spec.dy}, "grid");
    if (spec.layered || spec.body == BodyShape::layered) validate_layers(spec);
    if (spec.section || spec.body == BodyShape::longitudinally_uniform) validate_uniform(spec);
    validate(spec.material, "material", spec.source == IcSource::analytic);
    if (spec.line_contact)
        validate_line_contact(spec);
    else
        validate_aspect(spec);
    validate_body(spec);
    if (spec.accuracy != 0) validate_accuracy(spec);
    if (spec.any_nu) {
        if (spec.source == IcSource::analytic)
            throw InvalidArgument("ics.any_nu", "requires source fem; the closed form is equally fast for every nu");
        require(spec.material.nu <= largest_family_nu, "material.nu", spec.material.nu,
                "be at most 0.49, the end of a family over nu");
        if (spec.source == IcSource::fem && spec.accuracy == 0 && spec.fem.mesh == MeshKind::adaptive)
            throw InvalidArgument("ics.any_nu",
                                  "cannot be combined with mesh adaptive: each nu has its own mesh, and tables of "
                                  "different meshes cannot be interpolated");
    }
    if (spec.source != IcSource::fem) return;
    const bool chosen = spec.accuracy != 0;
    if (!chosen) {
        validate(spec.fem, spec.load_shape);
        const MeshSize size = mesh_size(spec);
        if (spec.fem.mesh != MeshKind::adaptive && size.elements > max_elements)
            throw InvalidArgument("ics", "requires a mesh of " + std::to_string(size.elements) +
                                             " elements, but at most " + std::to_string(max_elements) +
                                             " are allowed: use a larger f, or a smaller l_over_h, h_over_hs or "
                                             "L_over_h");
    }
    if (chosen && (spec.body == BodyShape::half_space || spec.section)) return;
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    if (spec.body == BodyShape::block) validate_room_on_block(spec);
    const double farthest = std::max((spec.nx - 1) * spec.dx, (spec.ny - 1) * spec.dy);
    if (!(farthest < L))
        throw InvalidArgument("ics.L_over_h", "is " + number_text(spec.fem.L_over_h) + "; the offsets reach " +
                                                  number_text(farthest) + " and must lie inside the block of size " +
                                                  number_text(L));
}

void validate(const IcSpec& spec, const std::string& material) {
    renaming(in_place_of("material", material), [&] { validate(spec); });
}

std::vector<std::string> warnings(const IcSpec& spec) {
    std::vector<std::string> result;
    const FemSpec& fem = spec.fem;
    if (spec.source != IcSource::fem || spec.accuracy != 0 || fem.mesh == MeshKind::adaptive) return result;
    const auto advise = [&](bool holds, const std::string& field, const std::string& value, const char* advice) {
        if (!holds) result.push_back(field + " is " + value + "; the paper advises " + advice + " (Table 3).");
    };
    // For a half-space, the error itself is known.
    if (const double most = largest_nu(fem.order); spec.body == BodyShape::block && spec.material.nu > most)
        result.push_back("nu is " + number_text(spec.material.nu) + "; elements of order " + std::to_string(fem.order) +
                         " lock near 1/2. Their errors may exceed 1 % above " + number_text(most) +
                         "; use a higher order.");
    // The paper's ranges apply only to its meshes of order 2 and u = 0 on the far faces.
    advise(fem.order >= 2, "order", std::to_string(fem.order), "quadratic elements");
    if (fem.far_boundary == FarBoundary::clamped && spec.body == BodyShape::half_space)
        advise(fem.L_over_h >= 80, "L_over_h", number_text(fem.L_over_h), "at least 80");
    if (fem.order > 2) return result;
    advise(fem.l_over_h >= 1 && fem.l_over_h <= 1.25, "l_over_h", number_text(fem.l_over_h), "1 to 1.25");
    advise(fem.h_over_hs >= 4, "h_over_hs", number_text(fem.h_over_hs), "at least 4");
    if (fem.mesh == MeshKind::hex)
        advise(fem.f <= 1.5, "f", number_text(fem.f), "1 to 1.5 on Mesh1");
    else
        advise(fem.f >= 1.5 && fem.f <= 2, "f", number_text(fem.f), "1.5 to 2 on Mesh2");
    return result;
}

MeshSize mesh_size(const IcSpec& spec) {
    const FemSpec& fem = spec.fem;
    const double h = std::sqrt(spec.dx * spec.dy), hs = h / fem.h_over_hs;
    const double thickness = fem.L_over_h * std::max(spec.dx, spec.dy) - fem.l_over_h * h;
    const double t1 = hs * (fem.t1_over_hs > 0 ? fem.t1_over_hs : fem.f);
    const double layers = fem.f == 1 ? thickness / t1 : std::log1p(thickness * (fem.f - 1) / t1) / std::log(fem.f);
    constexpr double most = 1e9;
    const int m = static_cast<int>(std::lround(std::clamp(fem.l_over_h * fem.h_over_hs, 0.0, most)));
    const int k = static_cast<int>(std::lround(std::clamp(layers, 1.0, most)));
    double elements = 1.0 * m * m * (m + 3.0 * k);
    // Mesh2 has a cross-section of m^2 + 2 m k quadrilaterals, each two triangles, times m + k slices.
    if (fem.mesh == MeshKind::prism && k < 1'000'000) elements = 2 * (1.0 * m * m + 2.0 * m * k) * (m + k);
    return {m, k, static_cast<long long>(std::min(elements, 9e18))};
}

IcSpec dimensionless(const IcSpec& spec) {
    IcSpec result = spec;
    result.material = {1, rounded(spec.material.nu)};
    result.dx = 1;
    result.dy = rounded(spec.dy / spec.dx);
    if (spec.any_nu) result.material.nu = 0;
    if (spec.line_contact) result.dy = 1;
    for_each_ics_part([&]<class Part>(const IcsPart<Part>& part) {
        if (std::optional<Part>& value = result.*part.member)
            for_each_part_field<Part>([&](const PartField<Part>& field) {
                double& number = (*value).*field.member;
                number = rounded(field.dimension == Dimension::length ? number / spec.dx : number);
            });
    });
    if (result.layered) {
        for (Layer& layer : result.layered->layers)
            layer = {rounded(layer.thickness / spec.dx), rounded(layer.G / spec.material.G), rounded(layer.nu)};
        Material& base = result.layered->base;
        if (!base.is_rigid()) base = {rounded(base.G / spec.material.G), rounded(base.nu)};
    }
    if (result.section) {
        // By finite elements, all lengths are over the width of a column, and any dx is served.
        const bool any_dx = spec.source == IcSource::fem;
        result.section = scaled(*result.section, 1 / (any_dx ? spec.dy : spec.dx));
        if (any_dx) {
            result.dy = 1;
            result.nx = static_cast<int>(max_grid_elements) / spec.ny;
        }
    }
    if (spec.source == IcSource::analytic) {
        result.fem = FemSpec{};
        return result;
    }
    FemSpec& fem = result.fem;
    if (spec.accuracy != 0) {
        // Requests do not differ by choices that are made later, nor by accuracies between two levels.
        result.accuracy = spec.accuracy >= 1e-2 ? 1e-2 : spec.accuracy >= 1e-3 ? 1e-3 : 1e-4;
        fem = FemSpec{};
        fem.L_over_h = spec.body == BodyShape::block ? rounded(spec.fem.L_over_h) : 0;
        return result;
    }
    for_each_fem_field([&]<class Value>(const FemField<Value>& field) {
        Value& value = fem.*field.member;
        if constexpr (std::is_same_v<Value, double>) value = rounded(value);
        if constexpr (std::is_same_v<Value, std::optional<double>>)
            if (value) value = rounded(*value);
        if (field.matters && !field.matters(fem)) value = FemSpec{}.*field.member;
    });
    if (fem.t1_over_hs == fem.f) fem.t1_over_hs = 0;
    return result;
}

}  // namespace contactd

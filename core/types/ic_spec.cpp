#include "contactd/ic_spec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/grid.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

constexpr long long max_elements = 200'000;  // some millions of unknowns: what one machine can hold

template <class Enum, std::size_t count>
using Names = std::array<std::pair<Enum, std::string_view>, count>;

constexpr Names<LoadShape, 1> load_shapes{{{LoadShape::constant, "constant"}}};
constexpr Names<IcSource, 2> ic_sources{{{IcSource::analytic, "analytic"}, {IcSource::fem, "fem"}}};
constexpr Names<MeshKind, 1> mesh_kinds{{{MeshKind::hex, "hex"}}};
constexpr Names<FarBoundary, 1> far_boundaries{{{FarBoundary::clamped, "clamped"}}};
constexpr Names<Sampling, 3> samplings{
    {{Sampling::fem, "fem"}, {Sampling::linear, "linear"}, {Sampling::linear_nodes, "linear_nodes"}}};

std::string_view find_name(const auto& names, auto value) {
    for (const auto& [known, name] : names)
        if (known == value) return name;
    throw InvalidArgument("ics", "holds a value without a name");
}

bool find_value(const auto& names, std::string_view wanted, auto& value) {
    for (const auto& [known, name] : names)
        if (name == wanted) {
            value = known;
            return true;
        }
    return false;
}

double rounded(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 11).ptr;
    double result = value;
    std::from_chars(text, end, result);
    return result + 0.0;  // no negative zero
}

bool is_whole(double value) {
    return std::abs(value - std::round(value)) < 1e-9 * std::max(1.0, std::abs(value));
}

void require(bool holds, const char* field, double value, const char* rule) {
    if (!holds) throw InvalidArgument(field, "is " + number_text(value) + "; it must " + rule);
}

void validate(const FemSpec& fem) {
    require(fem.order == 1 || fem.order == 2, "ics.order", fem.order, "be 1 or 2");
    require(std::isfinite(fem.h_over_hs) && fem.h_over_hs >= 2 && is_whole(fem.h_over_hs / 2), "ics.h_over_hs",
            fem.h_over_hs, "be an even integer, so that the load's edge lies on element faces");
    require(std::isfinite(fem.l_over_h) && fem.l_over_h >= 0.5, "ics.l_over_h", fem.l_over_h,
            "be at least 0.5, so that the cube holds the load");
    const double m = fem.l_over_h * fem.h_over_hs;
    require(is_whole(m), "ics.l_over_h", fem.l_over_h,
            "make l_over_h * h_over_hs an integer, so that the load's edge lies on element faces");
    require(m <= 1000, "ics.l_over_h", fem.l_over_h, "keep l_over_h * h_over_hs, the elements per edge, below 1000");
    require(fem.f >= 1 && fem.f <= 10, "ics.f", fem.f, "lie in [1, 10]");
    require(std::isfinite(fem.L_over_h) && fem.L_over_h > fem.l_over_h && fem.L_over_h <= 1e9, "ics.L_over_h",
            fem.L_over_h, "be larger than l_over_h and at most 1e9");
    require(fem.tolerance >= 1e-13 && fem.tolerance < 1, "ics.tolerance", fem.tolerance, "lie in [1e-13, 1)");
    require(fem.max_iterations >= 1, "ics.max_iterations", fem.max_iterations, "be at least 1");
    require(fem.strength_threshold >= 0 && fem.strength_threshold < 1, "ics.strength_threshold", fem.strength_threshold,
            "lie in [0, 1)");
}

}  // namespace

std::string_view name_of(LoadShape value) {
    return find_name(load_shapes, value);
}
std::string_view name_of(IcSource value) {
    return find_name(ic_sources, value);
}
std::string_view name_of(MeshKind value) {
    return find_name(mesh_kinds, value);
}
std::string_view name_of(FarBoundary value) {
    return find_name(far_boundaries, value);
}
std::string_view name_of(Sampling value) {
    return find_name(samplings, value);
}

bool from_name(std::string_view name, LoadShape& value) {
    return find_value(load_shapes, name, value);
}
bool from_name(std::string_view name, IcSource& value) {
    return find_value(ic_sources, name, value);
}
bool from_name(std::string_view name, MeshKind& value) {
    return find_value(mesh_kinds, name, value);
}
bool from_name(std::string_view name, FarBoundary& value) {
    return find_value(far_boundaries, name, value);
}
bool from_name(std::string_view name, Sampling& value) {
    return find_value(samplings, name, value);
}

std::optional<FemSpec> fem_preset(std::string_view name) {
    FemSpec fem;
    if (name == "paper-test3") return fem;
    fem.f = 1.5;
    if (name == "paper-test2") return fem;
    fem.l_over_h = 2.5;
    if (name == "paper-test1") return fem;
    return std::nullopt;
}

void validate(const IcSpec& spec) {
    validate(Grid{spec.nx, spec.ny, spec.dx, spec.dy}, "grid");
    validate(spec.material, "material", spec.source == IcSource::analytic);
    const double aspect = spec.dx / spec.dy;
    if (!(aspect >= 1e-3 && aspect <= 1e3))
        throw InvalidArgument("grid.dy", "gives dx/dy = " + number_text(aspect) + "; it must lie in [0.001, 1000]");
    if (spec.source != IcSource::fem) return;
    validate(spec.fem);
    if (const MeshSize size = mesh_size(spec); size.elements > max_elements)
        throw InvalidArgument("ics", "asks for a mesh of " + std::to_string(size.elements) + " elements; at most " +
                                         std::to_string(max_elements) +
                                         " are allowed: take a larger f, or a smaller l_over_h, h_over_hs or L_over_h");
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    const double farthest = std::max((spec.nx - 1) * spec.dx, (spec.ny - 1) * spec.dy);
    if (farthest >= L)
        throw InvalidArgument("ics.L_over_h", "is " + number_text(spec.fem.L_over_h) + "; the offsets reach " +
                                                  number_text(farthest) + " and must lie inside the block of size " +
                                                  number_text(L));
}

MeshSize mesh_size(const IcSpec& spec) {
    const FemSpec& fem = spec.fem;
    const double h = std::sqrt(spec.dx * spec.dy), hs = h / fem.h_over_hs;
    const double thickness = fem.L_over_h * std::max(spec.dx, spec.dy) - fem.l_over_h * h;
    const double layers =
        fem.f == 1 ? thickness / hs : std::log1p(thickness * (fem.f - 1) / (fem.f * hs)) / std::log(fem.f);
    constexpr double most = 1e9;
    const int m = static_cast<int>(std::lround(fem.l_over_h * fem.h_over_hs));
    const int k = static_cast<int>(std::lround(std::clamp(layers, 1.0, most)));
    return {m, k, 1LL * m * m * (m + 3LL * k)};
}

IcSpec dimensionless(const IcSpec& spec) {
    IcSpec result = spec;
    result.material = {1, rounded(spec.material.nu)};
    result.dx = 1;
    result.dy = rounded(spec.dy / spec.dx);
    if (spec.source == IcSource::analytic) {
        result.fem = FemSpec{};
    } else {
        result.fem.l_over_h = rounded(spec.fem.l_over_h);
        result.fem.h_over_hs = rounded(spec.fem.h_over_hs);
        result.fem.f = rounded(spec.fem.f);
        result.fem.L_over_h = rounded(spec.fem.L_over_h);
        result.fem.tolerance = rounded(spec.fem.tolerance);
        result.fem.strength_threshold = rounded(spec.fem.strength_threshold);
    }
    return result;
}

}  // namespace contactd

#include "contactd/half_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "kernel_integrals.hpp"

namespace contactd {
namespace {

KernelIntegrals integrals_at(const IcSpec& spec, double x, double y) {
    const bool is_bilinear = spec.load_shape == LoadShape::bilinear;
    if (spec.line_contact)
        return (is_bilinear ? bilinear_line_integrals : constant_line_integrals)(x, spec.dx, spec.line_contact->datum);
    return (is_bilinear ? bilinear_load_integrals : constant_load_integrals)(x, y, spec.dx, spec.dy);
}

// Returns the displacement along i for a load along j, times G.
double scaled_coefficient(Axis i, Axis j, const KernelIntegrals& k, double nu) {
    using std::numbers::pi;
    if (i == Axis::z && j == Axis::z) return (1 - nu) * (k.xx + k.yy) / (2 * pi);
    if (i == Axis::x && j == Axis::x) return (k.xx + (1 - nu) * k.yy) / (2 * pi);
    if (i == Axis::y && j == Axis::y) return (k.yy + (1 - nu) * k.xx) / (2 * pi);
    if (i != Axis::z && j != Axis::z) return nu * k.xy / (2 * pi);
    const Axis tangential = i == Axis::z ? j : i;
    const double sign = i == Axis::z ? -1 : 1;  // reciprocity: A_zx(x, y) = A_xz(-x, -y)
    return sign * (1 - 2 * nu) * (tangential == Axis::x ? k.x : k.y) / (4 * pi);
}

IcTable closed_form(const IcSpec& spec, const Observer& observer = {}) {
    IcTable table(spec.nx, spec.ny);
    for (int l = 0; l < spec.ny; ++l) {
        observer.throw_if_cancelled();
        for (int k = 0; k < spec.nx; ++k) {
            const KernelIntegrals integrals = integrals_at(spec, k * spec.dx, l * spec.dy);
            for (const Axis i : {Axis::x, Axis::y, Axis::z})
                for (const Axis j : {Axis::x, Axis::y, Axis::z})
                    table(i, j, k, l) = scaled_coefficient(i, j, integrals, spec.material.nu) / spec.material.G;
        }
    }
    return table;
}

// Returns the error; `unit` is the scale of errors, of the same sign everywhere.
ComponentError relative_error(const IcTable& table, const IcTable& exact, const IcTable& unit, Axis i) {
    ComponentError error;
    error.origin = table(i, i, 0, 0) / exact(i, i, 0, 0) - 1;
    for (int l = 0; l < exact.ny; ++l)
        for (int k = 0; k < exact.nx; ++k)
            error.largest = std::max(error.largest, std::abs(table(i, i, k, l) - exact(i, i, k, l)) / unit(i, i, k, l));
    return error;
}

double scaled_error(const IcSpec& spec, const IcTable& table, const IcTable& exact, Axis i, Axis j) {
    double largest = 0;
    for (int l = 0; l < exact.ny; ++l)
        for (int k = 0; k < exact.nx; ++k) {
            if (k == 0 && l == 0) continue;
            const double rho = std::hypot(k * spec.dx, l * spec.dy);
            largest = std::max(largest, std::abs(table(i, j, k, l) - exact(i, j, k, l)) * rho);
        }
    return largest * 2 * std::numbers::pi * spec.material.G / (spec.dx * spec.dy);
}

}  // namespace

double half_space_coefficient(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material) {
    return scaled_coefficient(i, j, constant_load_integrals(x, y, dx, dy), material.nu) / material.G;
}

double half_space_bilinear_coefficient(Axis i, Axis j, double x, double y, double dx, double dy,
                                       const Material& material) {
    return scaled_coefficient(i, j, bilinear_load_integrals(x, y, dx, dy), material.nu) / material.G;
}

IcTable half_space_table(const IcSpec& spec, const Observer& observer) {
    if (spec.source != IcSource::analytic)
        throw InvalidArgument("ics.source", "is fem; closed-form coefficients require analytic");
    validate(spec);
    return closed_form(spec, observer);
}

IcTable error_unit(const IcSpec& spec, const IcTable& exact) {
    IcTable unit = spec.body == BodyShape::block ? closed_form(spec) : IcTable(exact.nx, exact.ny);
    for (std::size_t i = 0; i < unit.values.size(); ++i)
        unit.values[i] = std::max(std::abs(exact.values[i]), block_error_floor * std::abs(unit.values[i]));
    return unit;
}

void compare_tables(const IcSpec& spec, const IcTable& table, const IcTable& exact, IcEvidence& evidence) {
    for (const IcTable* each : {&table, &exact})
        if (each->nx != spec.nx || each->ny != spec.ny)
            throw InvalidArgument("table", "has a different extent than its spec; both must be equal");
    const IcTable unit = error_unit(spec, exact);
    evidence.errors.xx = relative_error(table, exact, unit, Axis::x);
    evidence.errors.yy = relative_error(table, exact, unit, Axis::y);
    evidence.errors.zz = relative_error(table, exact, unit, Axis::z);
    const auto largest = [&](std::initializer_list<std::array<Axis, 2>> components) {
        double error = 0;
        for (const auto& [i, j] : components) error = std::max(error, scaled_error(spec, table, exact, i, j));
        return error;
    };
    using enum Axis;
    evidence.errors.scaled_xy = largest({{x, y}, {y, x}});
    evidence.errors.scaled_xz = largest({{x, z}, {z, x}, {y, z}, {z, y}});
}

void compare_with_half_space(const IcSpec& spec, const IcTable& table, IcEvidence& evidence) {
    if (spec.body != BodyShape::half_space)
        throw InvalidArgument("ics.body", "is block, which has no closed form to compare with");
    compare_tables(spec, table, closed_form(spec), evidence);
}

}  // namespace contactd

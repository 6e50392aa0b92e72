// Holds the parameters on which the tangential displacements of a pair of half-spaces depend.
#pragma once

#include <numbers>
#include <optional>

#include "contactd/ic_table.hpp"
#include "kernel_integrals.hpp"
#include "shifted_table.hpp"

namespace contactd {

/// Holds sums over the bodies, and for the coupling the difference lower - upper.
struct HalfSpaceModel {
    double a = 0;  ///< (1-nu)/G
    double b = 0;  ///< nu/G
    double c = 0;  ///< (1-2nu)/G
    LoadShape load_shape = LoadShape::constant;
    std::optional<LineContactSpec> line_contact;

    explicit HalfSpaceModel(const HalfSpaces& half_spaces);
    HalfSpaceModel(LoadShape load_shape_) : load_shape(load_shape_) {}

    bool coupled() const { return c != 0; }

    /// Returns A[i,j] of the pair, i = x or y.
    double coefficient(Axis i, Axis j, const KernelIntegrals& k) const {
        using std::numbers::pi;
        if (j == Axis::z) return c * (i == Axis::x ? k.x : k.y) / (4 * pi);
        if (i != j) return b * k.xy / (2 * pi);
        return (a * (k.xx + k.yy) + b * (i == Axis::x ? k.xx : k.yy)) / (2 * pi);
    }
    KernelIntegrals integrals(double x, double y, double dx, double dy) const {
        const bool is_bilinear = load_shape == LoadShape::bilinear;
        if (line_contact)
            return (is_bilinear ? bilinear_line_integrals : constant_line_integrals)(x, dx, line_contact->datum);
        return (is_bilinear ? bilinear_load_integrals : constant_load_integrals)(x, y, dx, dy);
    }
};

/// Returns the half-spaces whose coefficients have the same singularity under the load as those of `pair`. Near the
/// origin the difference is a polynomial.
HalfSpaceModel nearest_half_spaces(const IcTable& pair, double dx, double dy);

}  // namespace contactd

#include "soundness.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "contactd/error.hpp"
#include "contactd/fields/axis.hpp"
#include "contactd/half_space.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using enum Axis;

[[noreturn]] void refuse(const std::string& why) {
    throw InvalidArgument("datasets", why);
}

constexpr double rounding = 1e-9;

/// `allowed` is the stated error plus the error of interpolation between Poisson's ratios.
void require_at_most(double found, double allowed, const char* component) {
    if (found <= allowed * (1 + 1e-6) + rounding) return;
    refuse(std::string("have errors of ") + component + " of " + number_text(found) +
           " relative to the closed form of the half-space, but the stated errors are at most " + number_text(allowed));
}

void require_stated_errors(const IcTable& table, const IcSpec& spec, const IcEvidence& stated) {
    IcEvidence found;
    compare_with_half_space(spec, table, found);
    const IcErrors& errors = stated.errors;
    if (!errors.xx || !errors.yy || !errors.zz || !errors.scaled_xy || !errors.scaled_xz)
        refuse("lack their errors relative to the closed form, which every table of a half-space must state");
    const double added = std::max(stated.interpolation_error.value_or(0), 0.0);
    const auto allowed = [&](double error) {
        return (spec.accuracy > 0 ? std::min(error, spec.accuracy) : error) + added;
    };
    require_at_most(found.errors.xx->largest, allowed(errors.xx->largest), "xx");
    require_at_most(found.errors.yy->largest, allowed(errors.yy->largest), "yy");
    require_at_most(found.errors.zz->largest, allowed(errors.zz->largest), "zz");
    require_at_most(*found.errors.scaled_xy, allowed(*errors.scaled_xy), "xy or yx (times 2 pi G rho / (dx dy))");
    require_at_most(*found.errors.scaled_xz, allowed(*errors.scaled_xz), "xz, zx, yz or zy (the same)");
}

/// A block differs from the half-space by a smooth field as large as the half-space's displacements at its faces, which
/// are some h/L of those under the load. Stated errors are added to it.
constexpr double share_at_faces = 3, least_share = 0.02;
constexpr double largest_defect = 0.1;  // of reciprocity; coefficients of a block depend slightly on the loaded element

void require_near_half_space(const IcTable& table, const IcSpec& spec, const IcEvidence& stated) {
    IcSpec half_space = spec;
    half_space.body = BodyShape::half_space;
    half_space.source = IcSource::analytic;
    half_space.accuracy = 0;
    half_space.any_nu = false;
    const IcTable exact = half_space_table(half_space);
    double error = 0;
    for (const auto& one : {stated.errors.xx, stated.errors.yy, stated.errors.zz})
        if (one) error = std::max(error, one->largest);
    const double share = share_at_faces / spec.fem.L_over_h + 2 * error + least_share;
    for (const Axis i : {x, y, z})
        for (int l = 0; l < table.ny; ++l)
            for (int k = 0; k < table.nx; ++k)
                if (std::abs(table(i, i, k, l) - exact(i, i, k, l)) > share * exact(i, i, 0, 0))
                    refuse("contain " + number_text(table(i, i, k, l)) + " for " + std::string(name_of(i)) +
                           std::string(name_of(i)) + " at the offset (" + std::to_string(k) + ", " + std::to_string(l) +
                           "), where a half-space has " + number_text(exact(i, i, k, l)) +
                           "; a block of this size cannot differ by that much");
}

/// The displacement u_i here by a load j there equals u_j there by a load i here.
void require_reciprocal(const IcTable& table, const IcSpec& spec, const IcEvidence& stated) {
    const double scale = 2 * std::numbers::pi * spec.material.G / (spec.dx * spec.dy);
    const double allowed = largest_defect + 2 * std::max(stated.modelling_error.value_or(0), 0.0);
    for (int l = 0; l < table.ny; ++l)
        for (int k = 0; k < table.nx; ++k) {
            const double rho = std::hypot(k * spec.dx, l * spec.dy) * scale;
            const double defect = std::max({std::abs(table(x, y, k, l) - table(y, x, k, l)),
                                            std::abs(table(x, z, k, l) + table(z, x, k, l)),
                                            std::abs(table(y, z, k, l) + table(z, y, k, l))});
            if (defect * rho > allowed)
                refuse("are not reciprocal at the offset (" + std::to_string(k) + ", " + std::to_string(l) +
                       "): xy must be yx, xz the opposite of zx, yz that of zy, to " + number_text(allowed) +
                       " of dx dy / (2 pi G rho)");
        }
}

using Matrix = Eigen::MatrixXd;

bool is_positive_definite(const Matrix& matrix) {
    return Eigen::LLT<Matrix>(matrix).info() == Eigen::Success;
}

/// A principal submatrix of a positive definite matrix is positive definite, too, so elements on a lattice are
/// sufficient. Lattices of increasing strides check short and long waves.
constexpr int lattice = 8;

void require_work(const IcTable& table, const Observer& observer) {
    for (int stride = 1; stride <= std::max(table.nx, table.ny); stride *= 2) {
        observer.throw_if_cancelled();
        const int nx = std::min(lattice, (table.nx - 1) / stride + 1);
        const int ny = std::min(lattice, (table.ny - 1) / stride + 1);
        Matrix matrix(3 * nx * ny, 3 * nx * ny);
        for (int a = 0; a < nx * ny; ++a)
            for (int b = 0; b < nx * ny; ++b)
                for (const Axis i : {x, y, z})
                    for (const Axis j : {x, y, z})
                        matrix(3 * a + static_cast<int>(i), 3 * b + static_cast<int>(j)) =
                            table.at(i, j, stride * (a % nx - b % nx), stride * (a / nx - b / nx));
        matrix = (matrix + matrix.transpose().eval()) / 2;
        if (!is_positive_definite(matrix))
            refuse("give a traction on elements " + std::to_string(stride) +
                   " apart a negative elastic energy: coefficients must be positive definite");
    }
}

constexpr int window = 64;  // strips that are checked together

/// Checks the strips first, first + stride, ...
bool is_sound(const StripSpectrum& spectrum, std::size_t node, int first, int stride, int count, double slack) {
    Matrix matrix(3 * count, 3 * count);
    const auto entry = [&](int n) { return 3 * (first + stride * (n / 3)) + n % 3; };
    for (int a = 0; a < 3 * count; ++a)
        for (int b = 0; b <= a; ++b)
            matrix(a, b) = matrix(b, a) = spectrum.values[spectrum.index(node, entry(a), entry(b))];
    matrix.diagonal().array() += slack * matrix.diagonal().maxCoeff();
    return is_positive_definite(matrix);
}

}  // namespace

void require_sound(const IcTable& table, const IcSpec& spec, const IcEvidence& stated, const Observer& observer) {
    if (spec.body == BodyShape::half_space) {
        require_stated_errors(table, spec, stated);
    } else {
        require_near_half_space(table, spec, stated);
        require_reciprocal(table, spec, stated);
    }
    require_work(table, observer);
}

void require_sound(const StripSpectrum& spectrum, const IcEvidence& stated, bool is_free, const Observer& observer) {
    if (!stated.section) refuse("lack the errors that every transform of a section must state");
    constexpr double most_slack = 0.05;
    const double slack = std::clamp(stated.section->error, rounding, most_slack);
    for (std::size_t node = is_free ? 1 : 0; node < spectrum.nodes.size(); ++node) {
        observer.throw_if_cancelled();
        for (int stride = 1; stride <= spectrum.strips; stride *= 2)
            for (int first = 0; first < spectrum.strips; first += stride * window / 2) {
                const int count = std::min(window, (spectrum.strips - 1 - first) / stride + 1);
                if (!is_sound(spectrum, node, first, stride, count, slack))
                    refuse(
                        "contain a transform that gives a traction on strips a negative elastic energy at the "
                        "wavenumber " +
                        std::to_string(node) + ": it must be positive definite");
            }
    }
}

}  // namespace contactd

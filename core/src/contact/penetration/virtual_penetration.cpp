#include "virtual_penetration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "closed_forms/hertz.hpp"
#include "penetration_models.hpp"
#include "prescribed_pressures.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double tolerance = 1e-9;  // of a prescribed force
constexpr int most_rounds = 100;

class Penetration {
   public:
    Penetration(const ContactProblem& problem, std::span<const double> distance)
        : problem_(problem),
          distance_(distance),
          rows_(problem.grid, distance),
          compliance_(problem.bodies.materials().normal_compliance()),
          least_(rows_.least()) {
        for (const double h : distance) rounding_ = std::max(rounding_, 1e-14 * std::abs(h));
    }

    double least() const { return least_; }
    /// Returns the depth that Hertz's theory expects for a force, by the curvatures where the surfaces are nearest.
    double expected_depth(double Fn) const {
        const auto [along, across] = rows_.curvatures();
        return hertz_of_force({0.5 / along, 0.5 / across}, compliance_, Fn).approach;
    }
    /// Returns the overlap (mm) up to which there is no contact.
    double rounding() const { return rounding_; }

    /// Computes the pressures for d, the approach minus the least distance; returns the force (N).
    double solve(double d) {
        rows_.take_parabolas(d);
        switch (problem_.normal_model) {
            case NormalModel::kp:
                found_ = kp_shape(rows_, d);
                break;
            case NormalModel::kpec:
                found_ = kpec_shape(rows_, d, compliance_);
                break;
            default:
                found_ = analyn_pressures(rows_, d, compliance_);
                break;
        }
        if (problem_.normal_model != NormalModel::analyn) scale(d + rows_.least() - distance_[rows_.deepest_element()]);
        double sum = 0;
        for (const double p : found_.pressure) sum += p;
        return sum * problem_.grid.element_area();
    }

    const PenetrationPressures& found() const { return found_; }
    /// Mixes the computed pressures with a share of others.
    void blend(const PenetrationPressures& others, double share) {
        for (std::size_t i = 0; i < found_.pressure.size(); ++i)
            found_.pressure[i] += share * (others.pressure[i] - found_.pressure[i]);
        found_.is_beyond = found_.is_beyond || others.is_beyond;
    }

   private:
    /// Scales the pressures so that the displacement at the deepest element is `overlap`.
    void scale(double overlap) {
        const Grid& grid = problem_.grid;
        const auto columns = static_cast<std::size_t>(grid.nx);
        const std::size_t deepest = rows_.deepest_element();
        make_coefficients(deepest);
        double displacement = 0;
        for (std::size_t i = 0; i < found_.pressure.size(); ++i) {
            if (!(found_.pressure[i] > 0)) continue;
            const std::size_t iy = i / columns, ix = i % columns, jy = deepest / columns, jx = deepest % columns;
            const std::size_t dy = iy > jy ? iy - jy : jy - iy, dx = ix > jx ? ix - jx : jx - ix;
            displacement += found_.pressure[i] * coefficients_[dy * columns + dx];
        }
        if (!(displacement > 0)) return;
        for (double& p : found_.pressure) p *= overlap / displacement;
    }

    /// Computes the coefficients of both bodies together, by distance from an element in elements, up to the ends of
    /// the grid: those of a half-space with the sum of their compliances.
    void make_coefficients(std::size_t from) {
        if (!coefficients_.empty()) return;
        const Grid& grid = problem_.grid;
        const auto ix0 = static_cast<int>(from) % grid.nx, iy0 = static_cast<int>(from) / grid.nx;
        const int nx = std::max(ix0, grid.nx - 1 - ix0) + 1, ny = std::max(iy0, grid.ny - 1 - iy0) + 1;
        // They follow from Love's formula for a rectangle (Johnson, section 3.3), a sum over its corners.
        std::vector<double> corners;
        corners.reserve(static_cast<std::size_t>(nx + 1) * static_cast<std::size_t>(ny + 1));
        for (int iy = 0; iy <= ny; ++iy)
            for (int ix = 0; ix <= nx; ++ix) {
                const double x = (ix - 0.5) * grid.dx, y = (iy - 0.5) * grid.dy;
                corners.push_back(x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y)));
            }
        coefficients_.resize(grid.size());
        for (int iy = 0; iy < ny; ++iy)
            for (int ix = 0; ix < nx; ++ix) {
                const auto low = static_cast<std::size_t>(iy * (nx + 1) + ix),
                           high = low + static_cast<std::size_t>(nx) + 1;
                coefficients_[static_cast<std::size_t>(iy * grid.nx + ix)] =
                    compliance_ / std::numbers::pi *
                    (corners[high + 1] - corners[high] - corners[low + 1] + corners[low]);
            }
    }

    const ContactProblem& problem_;
    std::span<const double> distance_;
    DistanceRows rows_;
    double compliance_, least_, rounding_ = 0;
    std::vector<double> coefficients_;
    PenetrationPressures found_;
};

/// Finds d for a force by false position on a force that grows as d^(3/2). Brackets grow from `start` on, faster with
/// each iteration. If the force jumps across the target because other rows or another deepest element count, the
/// pressures are interpolated between both sides.
double carry(Penetration& penetration, double Fn, double start, SolverEvidence& evidence) {
    constexpr int enough = 40;
    const auto excess = [&](double d) {
        ++evidence.iterations;
        const double force = penetration.solve(d);
        evidence.residual = std::abs(force - Fn) / Fn;
        return std::cbrt((force / Fn) * (force / Fn)) - 1;
    };
    double low = 0, high = start, at_low = -1, at_high = excess(high);
    for (double beyond = 1.02; at_high < 0 && evidence.iterations < most_rounds;
         beyond = std::min(beyond * beyond, 2.0)) {
        low = high;
        at_low = at_high;
        high *= beyond / (1 + at_high > 0.5 ? 1 + at_high : 0.5);
        at_high = excess(high);
    }
    double d = high;
    int same = 0;
    while (evidence.residual > tolerance && evidence.iterations < most_rounds && high - low > 1e-15 * high) {
        d = evidence.iterations < enough ? (low * at_high - high * at_low) / (at_high - at_low)
                                         : std::midpoint(low, high);
        const double here = excess(d);
        const bool is_low = here < 0;
        // An end that stays counts half, because it would stay for ever otherwise.
        same = is_low ? std::max(same, 0) + 1 : std::min(same, 0) - 1;
        if (is_low) {
            low = d;
            at_low = here;
            if (same > 1) at_high *= 0.5;
        } else {
            high = d;
            at_high = here;
            if (same < -1) at_low *= 0.5;
        }
    }
    constexpr double closed = 1e-9;
    if (evidence.residual <= tolerance || !(high - low < closed * high)) return d;
    const double less = penetration.solve(low);
    const PenetrationPressures before = penetration.found();
    const double more = penetration.solve(high);
    if (!(less < Fn && Fn < more)) return high;
    penetration.blend(before, (more - Fn) / (more - less));
    evidence.residual = 0;
    return high;
}

void warn(const ContactProblem& problem, const PenetrationPressures& found, std::vector<std::string>& warnings) {
    if (!found.is_beyond) return;
    if (problem.normal_model == NormalModel::kpec)
        warnings.emplace_back(
            "The contact is outside the range of normal_model kpec: in some rows the overlap would exceed the approach "
            "and is limited to it. The surfaces are much flatter away from the point of first contact. Remove "
            "normal_model and use model full.");
    else
        warnings.emplace_back(
            "The contact is outside the range of normal_model analyn: some rows in contact are flat or concave across, "
            "and a curvature of 1e-4/mm replaces theirs. Remove normal_model and use model full.");
}

}  // namespace

PenetrationContact penetration_contact(const ContactProblem& problem, std::span<const double> distance) {
    if (problem.normal_model == NormalModel::elliptic || problem.normal_model == NormalModel::parabolic)
        return prescribed_contact(problem);
    const auto begin = std::chrono::steady_clock::now();
    if (problem.normal_model == NormalModel::analyn && problem.grid.ny < 3)
        throw InvalidArgument("grid.ny",
                              "is " + std::to_string(problem.grid.ny) +
                                  "; normal_model analyn computes lateral curvatures and requires at least three rows");
    Penetration penetration(problem, distance);
    PenetrationContact contact;
    contact.evidence.converged = true;
    contact.pressure.resize(problem.grid.size());
    double d = problem.approach ? *problem.approach - penetration.least() : 0;
    if (problem.Fn && *problem.Fn > 0) {
        d = carry(penetration, *problem.Fn, penetration.expected_depth(*problem.Fn), contact.evidence);
        contact.evidence.converged = contact.evidence.residual <= tolerance;
    } else if (d > penetration.rounding()) {
        penetration.solve(d);
    }
    if (d > penetration.rounding()) {
        contact.pressure = penetration.found().pressure;
        warn(problem, penetration.found(), contact.warnings);
    }
    for (const double p : contact.pressure) {
        contact.Fn += p * problem.grid.element_area();
        contact.pmax = std::max(contact.pmax, p);
    }
    contact.approach = problem.approach ? *problem.approach : d + penetration.least();
    contact.evidence.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return contact;
}

}  // namespace contactd

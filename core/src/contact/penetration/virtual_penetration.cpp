#include "virtual_penetration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "contactd/half_space.hpp"
#include "penetration_models.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double tolerance = 1e-9;  // of a force that is prescribed
constexpr int most_rounds = 100;

class Penetration {
   public:
    Penetration(const ContactProblem& problem, std::span<const double> distance)
        : problem_(problem), distance_(distance), compliance_(problem.bodies.materials().normal_compliance()) {
        least_ = DistanceRows(problem.grid, distance, 0).least();
        for (const double h : distance) rounding_ = std::max(rounding_, 1e-14 * std::abs(h));
    }

    double least() const { return least_; }
    /// Overlaps up to this are none (mm).
    double rounding() const { return rounding_; }

    /// Pressures for d, the approach less the least distance; returns the force (N).
    double solve(double d) {
        const DistanceRows rows(problem_.grid, distance_, d);
        switch (problem_.normal_model) {
            case NormalModel::kp:
                found_ = kp_shape(rows, d);
                break;
            case NormalModel::kpec:
                found_ = kpec_shape(rows, d, compliance_);
                break;
            default:
                found_ = analyn_pressures(rows, d, compliance_);
                break;
        }
        if (problem_.normal_model != NormalModel::analyn)
            scale(rows, d + rows.least() - distance_[rows.deepest_element()]);
        double sum = 0;
        for (const double p : found_.pressure) sum += p;
        return sum * problem_.grid.element_area();
    }

    const PenetrationPressures& found() const { return found_; }

   private:
    /// Gives the pressures the size whose displacement at the deepest element is `overlap`.
    void scale(const DistanceRows& rows, double overlap) {
        const Grid& grid = problem_.grid;
        const auto columns = static_cast<std::size_t>(grid.nx);
        const std::size_t deepest = rows.deepest_element();
        make_coefficients();
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

    /// Those of both bodies together, by distance in elements: a half-space with the sum of their compliances.
    void make_coefficients() {
        if (!coefficients_.empty()) return;
        const Grid& grid = problem_.grid;
        const Material both{1 / (2 * compliance_), 0};
        coefficients_.reserve(grid.size());
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix)
                coefficients_.push_back(
                    half_space_coefficient(Axis::z, Axis::z, ix * grid.dx, iy * grid.dy, grid.dx, grid.dy, both));
    }

    const ContactProblem& problem_;
    std::span<const double> distance_;
    double compliance_, least_ = 0, rounding_ = 0;
    std::vector<double> coefficients_;
    PenetrationPressures found_;
};

/// d for a force, by the rule of false position on a force that grows as d^(3/2), within brackets that are doubled.
double depth_for(Penetration& penetration, double Fn, double start, SolverEvidence& evidence) {
    const auto excess = [&](double d) {
        ++evidence.iterations;
        const double force = penetration.solve(d);
        evidence.residual = std::abs(force - Fn) / Fn;
        return std::cbrt(force / Fn) - 1;
    };
    double low = 0, high = start, at_low = -1, at_high = excess(high);
    while (at_high < 0 && evidence.iterations < most_rounds) {
        low = high;
        at_low = at_high;
        high *= 2;
        at_high = excess(high);
    }
    double d = high;
    int same = 0;
    while (evidence.residual > tolerance && evidence.iterations < most_rounds && high - low > 1e-15 * high) {
        d = (low * at_high - high * at_low) / (at_high - at_low);
        const double here = excess(d);
        const bool is_low = here < 0;
        // An end that stays counts half, or it would stay for ever.
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
    return d;
}

void warn(const ContactProblem& problem, const PenetrationPressures& found, std::vector<std::string>& warnings) {
    if (!found.is_beyond) return;
    if (problem.normal_model == NormalModel::kpec)
        warnings.emplace_back(
            "normal_model kpec is beyond what it is made for: in some rows the overlap would have to exceed the "
            "approach, "
            "and is cut there. The surfaces are much flatter off the place where they are nearest: take model full.");
    else
        warnings.emplace_back(
            "normal_model analyn is beyond what it is made for: some rows in contact are flat or concave across, and "
            "have "
            "a curvature of 1e-4/mm in their place: take model full.");
}

}  // namespace

PenetrationContact penetration_contact(const ContactProblem& problem, std::span<const double> distance) {
    const auto begin = std::chrono::steady_clock::now();
    if (problem.normal_model == NormalModel::analyn && problem.grid.ny < 3)
        throw InvalidArgument("grid.ny", "is " + std::to_string(problem.grid.ny) +
                                             "; normal_model analyn takes curvatures across from three rows at least");
    Penetration penetration(problem, distance);
    PenetrationContact contact;
    contact.evidence.converged = true;
    contact.pressure.resize(problem.grid.size());
    double d = problem.approach ? *problem.approach - penetration.least() : 0;
    if (problem.Fn && *problem.Fn > 0) {
        const Grid& grid = problem.grid;
        const double across = std::sqrt(grid.element_area() * static_cast<double>(grid.size()));
        const double start = *problem.Fn * problem.bodies.materials().normal_compliance() / across;
        d = depth_for(penetration, *problem.Fn, start, contact.evidence);
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

#include "contact_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Holds the variables of laws at an element that slips.
struct SlippingElement {
    double pressure = 0;       ///< (N/mm^2)
    double pressure_slip = 0;  ///< p |s| (N/mm^2)
    double dissipation = 0;    ///< |t s| (N/mm^2)
    double velocity = 0;       ///< V |s| (mm/s)
};

double power(const SlippingElement& element, double velocity) {
    constexpr double watt = 1e3;  // N mm/s
    return element.dissipation * velocity / watt;
}

double archard_k(const ArchardWear& law, const SlippingElement& element) {
    if (law.seizure && element.pressure > law.seizure->pressure * law.hardness) return law.seizure->k;
    const bool is_severe =
        law.severe && element.velocity > law.severe->velocity.least && element.velocity < law.severe->velocity.most;
    return is_severe ? law.severe->k : law.mild;
}

/// Returns the depth over the length of path at an element that slips; 0 for a law of whole patches.
double depth_per_path(const WearLaw& law, const SlippingElement& element, double velocity) {
    constexpr double joule = 1e3;       // N mm
    constexpr double kg_per_m3 = 1e-9;  // kg/mm^3
    if (law.archard) return archard_k(*law.archard, element) * element.pressure_slip / law.archard->hardness;
    if (law.energy) return law.energy->coefficient / joule * element.dissipation;
    if (law.usfd) {
        constexpr double microgram_per_m = 1e-12;  // kg/mm
        return value_at(law.usfd->pieces, element.dissipation) * microgram_per_m / (law.usfd->density * kg_per_m3);
    }
    if (law.zobory)
        return value_at(law.zobory->pieces, power(element, velocity)) / joule * element.dissipation /
               (law.zobory->density * kg_per_m3);
    return 0;
}

/// A wheel of diameter D turns once in pi D, so the area of a passage is that per distance times pi D.
double area_of_passage(const BrWear& law, double T_gamma) {
    constexpr double km = 1e6;  // mm
    return std::numbers::pi / km * value_at(law.pieces, T_gamma);
}

double argument_of(const WearLaw& law, const ContactWear& wear, double velocity) {
    if (law.archard) return wear.largest_sliding_velocity;
    if (law.br) return wear.T_gamma;
    if (law.zobory) return power({.dissipation = wear.largest_dissipation}, velocity);
    return wear.largest_dissipation;
}

/// Visits the elements that slip with the variables of laws; slips are multiplied by `factor`.
template <class Visit>
void visit_slip(const Grid& grid, const ContactSolution& solution, double velocity, double factor, const Visit& visit) {
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t i =
                static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
            if (solution.element_division[i] != ElementState::slip) continue;
            const double sx = factor * solution.slip_x[i], sy = factor * solution.slip_y[i];
            const double slip = std::hypot(sx, sy);
            visit(static_cast<std::size_t>(iy),
                  SlippingElement{.pressure = solution.pressure[i],
                                  .pressure_slip = solution.pressure[i] * slip,
                                  .dissipation = std::abs(solution.traction_x[i] * sx + solution.traction_y[i] * sy),
                                  .velocity = velocity * slip});
        }
}

double dissipation_of(const Grid& grid, const ContactSolution& solution) {
    double sum = 0;
    visit_slip(grid, solution, 0, 1, [&](std::size_t, const SlippingElement& element) { sum += element.dissipation; });
    return sum * grid.element_area();
}

/// Returns the energy from forces and rigid slip: elastic slip does not contribute in the limit of small elements.
double energy_by_forces(const ContactProblem& problem, const ContactSolution& solution, const Rolling& rolling) {
    const Forces& forces = solution.forces;
    double sum = forces.Fx * rolling.xi + forces.Fy * rolling.eta + forces.Mz * rolling.phi;
    double of_elements = 0;
    for (std::size_t i = 0; i < problem.rigid_slip.x.size(); ++i)
        of_elements +=
            solution.traction_x[i] * problem.rigid_slip.x[i] + solution.traction_y[i] * problem.rigid_slip.y[i];
    sum += of_elements * problem.grid.element_area();
    return 0 - sum;  // avoids a negative zero
}

void keep_rows_in_contact(const Grid& grid, const ContactSolution& solution, std::vector<WearRow>& rows) {
    const auto touches = [&](std::size_t row) {
        const auto begin = solution.pressure.begin() + static_cast<std::ptrdiff_t>(row) * grid.nx;
        return std::any_of(begin, begin + grid.nx, [](double p) { return p > 0; });
    };
    std::size_t first = 0, end = rows.size();
    while (first < end && !touches(first)) ++first;
    while (end > first && !touches(end - 1)) --end;
    rows = std::vector<WearRow>(rows.begin() + static_cast<std::ptrdiff_t>(first),
                                rows.begin() + static_cast<std::ptrdiff_t>(end));
}

void spread(const WearLaw& law, std::size_t index, double area, std::vector<WearRow>& rows, double dy) {
    double sum = 0;
    for (const WearRow& row : rows) sum += row.dissipation * dy;
    if (!(sum > 0)) return;
    for (WearRow& row : rows) row.depths[index] = area * row.dissipation / sum;
    for (WearRow& row : rows) row.depths[index] *= factor_at(law.zones, row.angle);
}

void warn_of_ranges(const WearRequest& request, const ContactWear& wear, std::vector<std::string>& warnings) {
    for (std::size_t i = 0; i < request.laws.size(); ++i) {
        const WearLaw& law = request.laws[i];
        const double argument = wear.laws[i].argument;
        if (!(argument > 0) || (argument >= law.range.least && argument <= law.range.most)) continue;
        warnings.push_back("The wear law " + law.name + " was tested from " + number_text(law.range.least) + " to " +
                           number_text(law.range.most) + ", and its argument is up to " + short_text(argument) +
                           " here. Depths beyond the range are extrapolated.");
    }
}

/// Sums over few elements are inaccurate, and a factor cannot correct their distribution.
void warn_of_factor(const ContactWear& wear, std::vector<std::string>& warnings) {
    constexpr double largest = 1.5;
    if (wear.factor <= largest && wear.factor >= 1 / largest) return;
    warnings.push_back(
        "The energy of the slip is " + short_text(wear.T_gamma_with_spin) + " N by forces and creepages, but " +
        short_text(wear.dissipation) +
        " N summed over the elements. The elements are too large for the depths of single rows; use smaller ones.");
}

}  // namespace

WearPlace wear_place(const ContactProblem& problem, const Rolling& rolling) {
    WearPlace place{.xi = rolling.xi, .eta = rolling.eta};
    for (int iy = 0; iy < problem.grid.ny; ++iy) place.rows.push_back({.y = problem.grid.y(iy)});
    if (problem.columns)
        for (std::size_t i = 0; i < place.rows.size(); ++i) {
            const StripFrame& frame = problem.columns->frames[i];
            place.rows[i] = {.y = frame.y, .z = frame.z, .angle = frame.angle};
        }
    return place;
}

ContactWear contact_wear(const WearRequest& request, const ContactProblem& problem, const WearPlace& place,
                         ContactSolution& solution) {
    // The motion is completed by components computed for a prescribed force.
    const auto& rolling = std::get<Rolling>(*solution.motion);
    const Grid& grid = problem.grid;
    ContactWear wear;
    wear.T_gamma = std::abs(solution.forces.Fx * place.xi + solution.forces.Fy * place.eta);
    wear.T_gamma_with_spin = energy_by_forces(problem, solution, rolling);
    wear.dissipation = dissipation_of(grid, solution);
    if (request.energy == WearEnergy::scaled && wear.dissipation > 0 && wear.T_gamma_with_spin > 0)
        wear.factor = wear.T_gamma_with_spin / wear.dissipation;
    wear.rows = place.rows;
    for (WearRow& row : wear.rows) row.depths.assign(request.laws.size(), 0);
    visit_slip(grid, solution, rolling.velocity, wear.factor, [&](std::size_t iy, const SlippingElement& element) {
        WearRow& row = wear.rows[iy];
        row.pressure_slip += element.pressure_slip * grid.dx;
        row.dissipation += element.dissipation * grid.dx;
        for (std::size_t i = 0; i < request.laws.size(); ++i)
            row.depths[i] += depth_per_path(request.laws[i], element, rolling.velocity) * grid.dx *
                             factor_at(request.laws[i].zones, row.angle);
        wear.largest_pressure_slip = std::max(wear.largest_pressure_slip, element.pressure_slip);
        wear.largest_dissipation = std::max(wear.largest_dissipation, element.dissipation);
        wear.largest_sliding_velocity = std::max(wear.largest_sliding_velocity, element.velocity);
    });
    for (std::size_t i = 0; i < request.laws.size(); ++i) {
        const WearLaw& law = request.laws[i];
        if (law.br) spread(law, i, area_of_passage(*law.br, wear.T_gamma), wear.rows, grid.dy);
        LawWear made{law.name, law.body};
        for (const WearRow& row : wear.rows) {
            made.area += row.depths[i] * grid.dy;
            made.depth = std::max(made.depth, row.depths[i]);
        }
        made.argument = argument_of(law, wear, rolling.velocity);
        wear.laws.push_back(std::move(made));
    }
    keep_rows_in_contact(grid, solution, wear.rows);
    warn_of_ranges(request, wear, solution.warnings);
    warn_of_factor(wear, solution.warnings);
    return wear;
}

}  // namespace contactd

#include "contact_fatigue.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "dang_van.hpp"
#include "passage_stress.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Holds the largest of values at the nodes of an axis, and its position.
struct Peak {
    double value = 0, at = 0;
};

/// Returns the vertex of the parabola through the largest value and its neighbours, from the node `first` on.
Peak peak_of(const std::vector<double>& nodes, const std::vector<double>& values, std::size_t first) {
    const auto i = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    const Peak at_node{values[i], nodes[i]};
    if (i <= first || i + 1 >= values.size()) return at_node;
    const double left = nodes[i] - nodes[i - 1], right = nodes[i + 1] - nodes[i];
    const double falls_left = (values[i] - values[i - 1]) / left, falls_right = (values[i] - values[i + 1]) / right;
    const double curvature = (falls_left + falls_right) / (left + right);
    if (!(curvature > 0)) return at_node;
    const double slope = (falls_left * right - falls_right * left) / (left + right);
    return {values[i] + slope * slope / (4 * curvature), nodes[i] + slope / (2 * curvature)};
}

std::vector<FatigueRow> rows_of(const ContactProblem& problem, const FatiguePlace& place, const ContactBox& box,
                                const ContactSolution& solution) {
    const Grid& grid = problem.grid;
    const double sign = problem.fatigue->body == WornBody::upper ? 1 : -1;
    std::vector<FatigueRow> rows;
    for (int iy = box.first_y; iy < box.end_y; ++iy) {
        const WearRow& at = place.wear.rows[static_cast<std::size_t>(iy)];
        FatigueRow row{.y = at.y, .z = at.z, .angle = at.angle};
        for (int ix = 0; ix < grid.nx; ++ix) {
            const auto i =
                static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
            const double tx = solution.traction_x[i], ty = solution.traction_y[i];
            row.pressure = std::max(row.pressure, solution.pressure[i]);
            row.traction = std::max(row.traction, std::hypot(tx, ty));
            row.force_x += sign * tx * grid.dx;
            row.force_y += sign * ty * grid.dx;
        }
        rows.push_back(row);
    }
    return rows;
}

/// Returns the largest |xz| of a line of points, also between points.
double shear_of(const PassageStress& passage, std::size_t begin) {
    std::vector<double> nodes(passage.nx), values(passage.nx);
    for (std::size_t i = 0; i < passage.nx; ++i) {
        nodes[i] = static_cast<double>(i) * passage.dx;
        values[i] = std::abs(passage.stress.xz[begin + i]);
    }
    return peak_of(nodes, values, 0).value;
}

double dang_van_of(const PassageStress& passage, std::size_t begin, double a_DV, double residual) {
    const SubsurfaceStress& s = passage.stress;
    std::vector<StressTensor> history(passage.nx);
    for (std::size_t i = 0; i < passage.nx; ++i) {
        const std::size_t at = begin + i;
        history[i] = {s.xx[at], s.yy[at], s.zz[at], s.xy[at], s.xz[at], s.yz[at]};
    }
    return dang_van_stress(history, a_DV, residual);
}

double residual_mean(const FatigueRequest& request, double depth) {
    const ResidualStress residual = residual_at(request.passage->residual, depth);
    return (residual.xx + residual.yy) / 3;
}

void keep_largest(std::optional<StressPlace>& largest, const FatigueRow& row, const Peak& peak) {
    if (!largest || peak.value > largest->value) largest = StressPlace{peak.value, row.y, row.z, peak.at};
}

/// Adds all results from the stresses of a passage.
void add_passage(const FatigueRequest& request, const PassageStress& passage, ContactFatigue& fatigue,
                 const Observer& observer) {
    const bool has_surface = passage.depths.front() == 0;
    const bool has_dang_van = request.strength && request.strength->a_DV;
    const double a_DV = has_dang_van ? *request.strength->a_DV : 0;
    for (std::size_t r = 0; r < fatigue.rows.size(); ++r) {
        observer.throw_if_cancelled();
        FatigueRow& row = fatigue.rows[r];
        std::vector<double> shear, von_mises, dang_van;
        for (std::size_t d = 0; d < passage.depths.size(); ++d) {
            const std::size_t begin = passage.begin_of(d, r);
            const auto first = passage.stress.von_mises.begin() + static_cast<std::ptrdiff_t>(begin);
            shear.push_back(d == 0 && has_surface ? row.traction : shear_of(passage, begin));
            von_mises.push_back(*std::max_element(first, first + static_cast<std::ptrdiff_t>(passage.nx)));
            if (has_dang_van)
                dang_van.push_back(dang_van_of(passage, begin, a_DV, residual_mean(request, passage.depths[d])));
        }
        const Peak of_shear = peak_of(passage.depths, shear, has_surface ? 1 : 0);
        row.shear = of_shear.value;
        row.shear_depth = of_shear.at;
        keep_largest(fatigue.shear, row, of_shear);
        keep_largest(fatigue.von_mises, row, peak_of(passage.depths, von_mises, has_surface ? 1 : 0));
        if (!has_dang_van) continue;
        const Peak of_dang_van = peak_of(passage.depths, dang_van, has_surface ? 1 : 0);
        row.dang_van = of_dang_van.value;
        row.dang_van_depth = of_dang_van.at;
        keep_largest(fatigue.dang_van, row, of_dang_van);
    }
    if (fatigue.dang_van && request.strength->tau_e)
        fatigue.utilisation = fatigue.dang_van->value / *request.strength->tau_e;
}

void add_indices(const FatigueRequest& request, const ContactSolution& solution, ContactFatigue& fatigue) {
    const double Fn = solution.forces.Fn, area = solution.area.contact;
    if (!(Fn > 0 && area > 0)) return;
    const double mu_u = fatigue.traction_coefficient;
    fatigue.FI_sub = Fn * (1 + mu_u * mu_u) / (4 * area);
    if (!request.strength) return;
    const FatigueStrength& strength = *request.strength;
    fatigue.FI_surf = mu_u - 2 * area * strength.shear_yield / (3 * Fn);
    fatigue.load = solution.pmax / strength.shear_yield;
    if (!strength.a_DV || !request.passage || request.passage->residual.empty()) return;
    double largest = residual_mean(request, 0);
    for (const ResidualStress& entry : request.passage->residual)
        largest = std::max(largest, residual_mean(request, entry.depth));
    fatigue.FI_sub += *strength.a_DV * largest;
}

void add_damages(const FatigueRequest& request, ContactFatigue& fatigue, std::vector<std::string>& warnings) {
    for (const DamageFunction& function : request.damages) {
        fatigue.damages.push_back({function.name, value_at(function.pieces, fatigue.T_gamma)});
        if (!(fatigue.T_gamma > 0) ||
            (fatigue.T_gamma >= function.range.least && fatigue.T_gamma <= function.range.most))
            continue;
        warnings.push_back("The damage function " + function.name + " was fitted from " +
                           number_text(function.range.least) + " to " + number_text(function.range.most) +
                           " N, but T gamma is " + short_text(fatigue.T_gamma) +
                           " N here. The reported damage is extrapolated.");
    }
}

/// Warns if elastic stresses are far beyond yield.
void warn_of_flow(const FatigueRequest& request, const ContactFatigue& fatigue, std::vector<std::string>& warnings) {
    constexpr double most = 4;  // limit of shakedown in frictionless rolling (Johnson, section 9.2)
    if (!request.strength || !fatigue.load || *fatigue.load <= most) return;
    warnings.push_back("The largest pressure is " + short_text(*fatigue.load) +
                       " times the yield strength in shear of " + request.strength->name +
                       ": the elastic limit is exceeded, and the elastic stresses reported are upper bounds.");
}

}  // namespace

FatiguePlace fatigue_place(const ContactProblem& problem, const Rolling& rolling) {
    FatiguePlace place{.wear = wear_place(problem, rolling)};
    if (problem.columns)
        for (const StripFrame& frame : problem.columns->frames) place.angles.push_back(0 - frame.angle);
    return place;
}

ContactFatigue contact_fatigue(const ContactProblem& problem, const FatiguePlace& place, ContactSolution& solution,
                               Observer& observer) {
    const FatigueRequest& request = *problem.fatigue;
    const Forces& forces = solution.forces;
    const auto& rolling = std::get<Rolling>(*solution.motion);
    ContactFatigue fatigue{.body = request.body};
    fatigue.T_gamma = std::abs(forces.Fx * place.wear.xi + forces.Fy * place.wear.eta);
    if (forces.Fn > 0) fatigue.traction_coefficient = std::hypot(forces.Fx, forces.Fy) / forces.Fn;
    // The contact moves along the rolling direction over both bodies.
    const double way = std::cos(rolling.chi) < 0 ? -1 : 1, sign = request.body == WornBody::upper ? way : 0 - way;
    if (fatigue.traction_coefficient > 0) fatigue.force_angle = std::atan2(sign * forces.Fy, sign * forces.Fx);
    fatigue.driven = sign * forces.Fx < 0;
    add_indices(request, solution, fatigue);
    add_damages(request, fatigue, solution.warnings);
    const ContactBox box = contact_box(problem.grid, solution.pressure);
    if (box.empty()) return fatigue;
    fatigue.rows = rows_of(problem, place, box, solution);
    if (request.passage) {
        add_passage(request, passage_stress(problem, solution, box, place.angles, observer), fatigue, observer);
        if (fatigue.shear->value > 0) fatigue.limit = solution.pmax / fatigue.shear->value;
    }
    warn_of_flow(request, fatigue, solution.warnings);
    return fatigue;
}

}  // namespace contactd

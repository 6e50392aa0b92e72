#include "contactd/creep_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "creep_table/open_table.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using creep_table::ScaledForces;
using creep_table::Triple;

constexpr double rounding = 1e-9;  // of log(a/b), by which contacts may lie outside of the table

void require_positive(const char* field, double value) {
    if (!(value > 0 && std::isfinite(value)))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must be positive and finite");
}

double dot(const Triple& row, const Triple& w) {
    return row[0] * w[0] + row[1] * w[1] + row[2] * w[2];
}

}  // namespace

CreepTable::CreepTable(const std::filesystem::path& path, std::optional<double> nu)
    : contents_(std::make_shared<const Contents>(path, nu)) {}

std::array<double, 2> CreepTable::ratios() const {
    const creep_table::SplineAxis& axis = contents_->spline.grid.axes[creep_table::log_ratio];
    return {std::exp(axis.from), std::exp(axis.to)};
}

double CreepTable::nu() const {
    return contents_->nu;
}

std::string_view CreepTable::description() const {
    return contents_->file.description;
}

CreepForces CreepTable::forces(const CreepContact& contact, const std::array<double, 3>& creepages) const {
    const auto [a, b, G, mu, Fn] = contact;
    require_positive("a", a);
    require_positive("b", b);
    require_positive("G", G);
    require_positive("mu", mu);
    require_positive("Fn", Fn);
    const creep_table::SplineAxis& axis = contents_->spline.grid.axes[creep_table::log_ratio];
    const double log_ratio = std::log(a / b);
    if (!(log_ratio >= axis.from - rounding && log_ratio <= axis.to + rounding))
        throw InvalidArgument("a", "is " + short_text(a / b) + " times b; the table holds a/b from " +
                                       short_text(std::exp(axis.from)) + " to " + short_text(std::exp(axis.to)));
    const double c2 = a * b, c = std::sqrt(c2), bound = mu * Fn, unit = G * c2 / bound;
    const Triple w{unit * creepages[0], unit * creepages[1], unit * c * creepages[2]};
    const ScaledForces scaled = creep_table::evaluate(contents_->spline, std::clamp(log_ratio, axis.from, axis.to), w);

    CreepForces result;
    result.force_bound = bound * scaled.bounds[0];
    result.moment_bound = bound * c * scaled.bounds[1];
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = -bound * (i == 2 ? c : 1), of_c = i == 2 ? 0.5 : 0;  // the power of ab in the size
        const Triple& row = scaled.by_creepage[i];
        const double value = scaled.forces[i], along = dot(row, w);
        const double by_log_area = of_c * value + row[0] * w[0] + row[1] * w[1] + 1.5 * row[2] * w[2];
        result.forces[i] = size * value;
        result.by_creepage[i] = {size * row[0] * unit, size * row[1] * unit, size * row[2] * unit * c};
        result.by_contact[i] = {size * (by_log_area + scaled.by_log_ratio[i]) / a,
                                size * (by_log_area - scaled.by_log_ratio[i]) / b, size * along / G,
                                size * (value - along) / mu, size * (value - along) / Fn};
    }
    return result;
}

}  // namespace contactd

#include "contactd/surface_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "contactd/error.hpp"
#include "row_heat.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double least_peclet = 10, steel_transforms = 800;

void check(const TemperatureRequest& request) {
    validate(request.grid, "grid");
    validate(request.temperature, "temperature");
    if (!(request.velocity > 0 && request.velocity <= 1e12))
        throw InvalidArgument("velocity", "is " + number_text(request.velocity) + "; it must lie in (0, 1e12] mm/s");
    if (request.upper_speed && !(*request.upper_speed >= 0 && *request.upper_speed <= 1e12))
        throw InvalidArgument("upper_speed",
                              "is " + number_text(*request.upper_speed) + "; it must lie in [0, 1e12] mm/s");
    if (!rolls_along_x(request.chi))
        throw InvalidArgument(
            "chi",
            "is " + number_text(request.chi) +
                "; temperatures require rolling along x, in which heat stays in its row of elements: use 0 or pi");
    if (request.flow_x.empty() != request.flow_y.empty())
        throw InvalidArgument(request.flow_x.empty() ? "flow_y" : "flow_x",
                              "is given alone. Give flow_x and flow_y, or neither.");
    for (const auto& [values, field] :
         {std::pair{&request.pressure, "pressure"}, std::pair{&request.traction_x, "traction_x"},
          std::pair{&request.traction_y, "traction_y"}, std::pair{&request.slip_x, "slip_x"},
          std::pair{&request.slip_y, "slip_y"}, std::pair{&request.flow_x, "flow_x"},
          std::pair{&request.flow_y, "flow_y"}}) {
        if (values->empty() && (values == &request.flow_x || values == &request.flow_y)) continue;
        if (values->size() != request.grid.size())
            throw InvalidArgument(field, "has " + std::to_string(values->size()) + " values; the grid has " +
                                             std::to_string(request.grid.size()) + " elements");
        for (const double value : *values)
            if (!(std::abs(value) <= 1e100))
                throw InvalidArgument(field,
                                      "contains " + number_text(value) + "; its values must lie in [-1e100, 1e100]");
    }
}

class Surfaces {
   public:
    Surfaces(const TemperatureRequest& request)
        : request_(request),
          nx_(static_cast<std::size_t>(request.grid.nx)),
          ny_(static_cast<std::size_t>(request.grid.ny)),
          heat_(request.temperature, request.velocity, request.upper_speed, request.grid.dx, nx_),
          backwards_(std::cos(request.chi) < 0),
          slips_(mean_slip_of_rows(nx_, request.pressure, request.slip_x, request.flow_x)) {}

    SurfaceTemperatures find(Observer& observer) {
        result_.upper_temperature.assign(request_.grid.size(), request_.temperature.upper.bulk_temperature);
        result_.lower_temperature.assign(request_.grid.size(), request_.temperature.below().bulk_temperature);
        for (std::size_t row = 0; row < ny_; ++row) {
            observer.throw_if_cancelled();
            take_row(row);
        }
        observer.on_progress({"temperature", 1});
        sum_up();
        warn();
        return std::move(result_);
    }

   private:
    /// Returns the element that lies `behind` elements behind the foremost one of the grid's row.
    std::size_t at(std::size_t row, std::size_t behind) const {
        return row * nx_ + (backwards_ ? behind : nx_ - 1 - behind);
    }

    // Returns the power per area (N/(mm s)). Residual slip in adhesion may have either sign, so negative work is
    // excluded.
    double heat_at(std::size_t i) const {
        const double work = request_.traction_x[i] * request_.slip_x[i] + request_.traction_y[i] * request_.slip_y[i];
        return (std::max(0.0, -work) + plastic_heat_at(i)) * request_.velocity;
    }

    double plastic_heat_at(std::size_t i) const {
        if (request_.flow_x.empty()) return 0;
        const double work = request_.traction_x[i] * request_.flow_x[i] + request_.traction_y[i] * request_.flow_y[i];
        return request_.temperature.plastic_share * std::max(0.0, work);
    }

    void take_row(std::size_t row) {
        shares_ = heat_.shares(backwards_ ? -slips_[row] : slips_[row]);
        std::size_t first = nx_, last = 0;
        for (std::size_t k = 0; k < nx_; ++k) {
            if (!(request_.pressure[at(row, k)] > 0)) continue;
            if (first < nx_ && k > last + 1) has_gaps_ = true;
            if (first == nx_) first = k;
            last = k;
        }
        if (first == nx_) return;
        has_opposite_ = has_opposite_ || shares_.opposite;
        take_length(last - first + 1);
        add_bulk(row, first, last);
        Values heat(last - first + 1);
        for (std::size_t k = first; k <= last; ++k) {
            heat[k - first] = heat_at(at(row, k));
            heat_sum_ += heat[k - first];
            heat_of_upper_ += heat[k - first] * shares_.share_of_upper;
        }
        for (std::size_t k = first; k < nx_; ++k) add_rise(at(row, k), rise_at(heat, k - first));
    }

    double rise_at(const Values& heat, std::size_t k) const {
        double sum = 0;
        for (std::size_t ahead = 0; ahead <= std::min(k, heat.size() - 1); ++ahead)
            sum += heat[ahead] * heat_.weight(k - ahead);
        return shares_.unit * sum;
    }

    // Records the smaller Peclet number of both bodies for the longest row, and the smallest for rows of the same
    // length.
    void take_length(std::size_t length) {
        if (length < longest_) return;
        if (length > longest_) peclet_ = std::numeric_limits<double>::infinity();
        longest_ = length;
        const ThermalBodies& bodies = request_.temperature;
        for (const auto& [body, speed] :
             {std::pair{&bodies.upper, shares_.speed_upper}, std::pair{&bodies.below(), shares_.speed_lower}})
            if (body->diffusivity() > 0)
                peclet_ = std::min(peclet_,
                                   speed * static_cast<double>(length) * request_.grid.dx / (2 * body->diffusivity()));
    }

    void add_rise(std::size_t i, double rise) {
        result_.upper_temperature[i] += rise;
        result_.lower_temperature[i] += rise;
        result_.temperature.rise = std::max(result_.temperature.rise, rise);
    }

    void add_bulk(std::size_t row, std::size_t first, std::size_t last) {
        const double upper = request_.temperature.upper.bulk_temperature,
                     lower = request_.temperature.below().bulk_temperature, contact = shares_.contact_temperature;
        if (upper == lower) return;
        const auto length = static_cast<double>(last - first + 1);
        for (std::size_t k = first; k < nx_; ++k) {
            const double share = k <= last ? 1
                                           : 2 / std::numbers::pi *
                                                 std::asin(std::sqrt(length / (static_cast<double>(k - first) + 0.5)));
            result_.upper_temperature[at(row, k)] = upper + (contact - upper) * share;
            result_.lower_temperature[at(row, k)] = lower + (contact - lower) * share;
        }
    }

    void sum_up() {
        ContactTemperature& summary = result_.temperature;
        std::size_t place = 0;
        summary.largest = longest_ > 0 ? -std::numeric_limits<double>::infinity()
                                       : std::max(request_.temperature.upper.bulk_temperature,
                                                  request_.temperature.below().bulk_temperature);
        for (std::size_t i = 0; i < result_.upper_temperature.size(); ++i) {
            if (!(request_.pressure[i] > 0 && result_.upper_temperature[i] > summary.largest)) continue;
            summary.largest = result_.upper_temperature[i];
            place = i;
        }
        summary.x = request_.grid.x(static_cast<int>(place % nx_));
        summary.y = request_.grid.y(static_cast<int>(place / nx_));
        summary.largest_upper = std::ranges::max(result_.upper_temperature);
        summary.largest_lower = std::ranges::max(result_.lower_temperature);
        summary.heat_upper = heat_of_upper_ * request_.grid.element_area();
        summary.heat_lower = (heat_sum_ - heat_of_upper_) * request_.grid.element_area();
        summary.peclet = peclet_;
    }

    void warn() {
        if (longest_ == 0) return;
        if (result_.temperature.peclet < least_peclet)
            result_.warnings.push_back("The Peclet number is " + short_text(result_.temperature.peclet) +
                                       ", below 10. Heat also spreads along the surface, which the reported "
                                       "temperatures neglect. They are those of fast surfaces; check the velocity "
                                       "(mm/s), and whether one of the bodies slides without rolling.");
        if (has_opposite_)
            result_.warnings.push_back(
                "The surfaces pass through the contact in opposite directions, because the slip exceeds the speed of "
                "one of them. Temperatures behind it assume the same direction.");
        if (has_gaps_)
            result_.warnings.push_back(
                "Rows of elements have gaps in their contact. Temperatures assume that both bodies are in contact from "
                "the first element to the last.");
        if (result_.temperature.largest > steel_transforms)
            result_.warnings.push_back(
                "The largest temperature is " + short_text(result_.temperature.largest) +
                " degrees Celsius. Steel transforms above 800, but thermal properties are assumed constant.");
    }

    const TemperatureRequest& request_;
    const std::size_t nx_, ny_;
    const RowHeat heat_;
    const bool backwards_;  // whether rolling is along -x, with the leading edge at small x
    const Values slips_;    // along x, of each row
    RowShares shares_;      // of the present row
    bool has_gaps_ = false, has_opposite_ = false;
    std::size_t longest_ = 0;  // in elements from the first to the last in contact
    double peclet_ = 0;
    double heat_sum_ = 0, heat_of_upper_ = 0;
    SurfaceTemperatures result_;
};

}  // namespace

SurfaceTemperatures surface_temperature(const TemperatureRequest& request, Observer& observer) {
    check(request);
    return Surfaces(request).find(observer);
}

}  // namespace contactd

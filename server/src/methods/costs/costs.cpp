#include "costs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "contactd/proto/status.hpp"
#include "request_limits.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

// Bytes for each element, measured as the growth of a daemon (tests/integration/test_bounds.py holds them to that).
constexpr double bytes_of_normal = 600;       // normal contact: a table, its symbols, and the solver's arrays
constexpr double bytes_of_tangential = 1700;  // friction, too
constexpr double bytes_of_rolling = 2600;     // and what a step of rolling changes
constexpr double bytes_of_simplified = 400;   // closed forms, which have fields and no operators
constexpr double bytes_of_answer = 150;       // all fields, as arrays of an answer and its frames
// Numbers for each offset along x and pair of strips: the table and its copy, symbols, boxes.
constexpr double bytes_of_strips = 30 * sizeof(double), bytes_of_rolling_strips = 60 * sizeof(double);
constexpr double bytes_of_stress = 8 * 14, bytes_of_offset = 8 * 40;
constexpr double bytes_beside = 1e6;

// Seconds: a product by FFT takes so long for each element and power of two of them, one with strips by their pairs.
// Measured; what is stated is 1.5 to 3 times what most requests take, for others need more products.
constexpr double seconds_of_product = 6e-9, seconds_of_pair = 2.4e-8, seconds_of_corner = 1.5e-7;
constexpr double products_of_normal = 15, products_of_friction = 200, products_of_step = 50;
constexpr double products_of_wheel = 100;  // with the search for its height
constexpr double seconds_of_position = 1e-3, seconds_of_amplitude = 5e-3;
constexpr double seconds_of_offset = 1e-6, seconds_of_layered_offset = 4e-5;

double sides(const json& grid) {
    return grid.at("nx").get<double>() * grid.at("ny").get<double>();
}

const json* member(const json& params, const char* name) {
    const auto at = params.find(name);
    return at == params.end() ? nullptr : &*at;
}

/// Whether any body of a contact, or its pair, has coefficients of this kind.
bool any_body(const json& params, const char* kind) {
    const auto is_kind = [&](const json* body) {
        const json* ics = body != nullptr && body->is_object() ? member(*body, "ics") : nullptr;
        return ics != nullptr && ics->is_object() && ics->value("body", "") == kind;
    };
    const json* bodies = member(params, "bodies");
    if (bodies == nullptr) return is_kind(&params);
    return is_kind(&params) || is_kind(member(*bodies, "upper")) || is_kind(member(*bodies, "lower"));
}

/// The length of the first axis of an array, a list or a frame.
double length_of(const json& array) {
    if (array.is_array()) return static_cast<double>(array.size());
    const json& shape = array.at("$array").at("shape");
    return shape.empty() ? 1 : shape.front().get<double>();
}

/// Counts all numbers of an array, a nested list or a frame.
double numbers_of(const json& array) {
    if (array.is_array())
        return array.empty() || !array.front().is_array()
                   ? static_cast<double>(array.size())
                   : static_cast<double>(array.size()) * numbers_of(array.front());
    double numbers = 1;
    if (array.is_object())
        for (const json& extent : array.at("$array").at("shape")) numbers *= extent.get<double>();
    return numbers;
}

double pairs_of_strips(const json& grid) {
    return sides(grid) * grid.at("ny").get<double>();
}

}  // namespace

WorkCost cost_of_solve(const json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const json& grid = params.at("grid");
    const double elements = sides(grid);
    if (params.value("model", "full") != "full")
        return {bytes_beside + elements * (bytes_of_simplified + bytes_of_answer), 1e-6 * elements};
    const json* friction = member(params, "friction");
    const bool rolls = friction != nullptr && friction->contains("rolling");
    double bytes = elements * (rolls ? bytes_of_rolling : friction != nullptr ? bytes_of_tangential : bytes_of_normal);
    double product = seconds_of_product * elements * std::log2(4 * elements + 2);
    if (any_body(params, "longitudinally_uniform")) {
        bytes += pairs_of_strips(grid) * (rolls ? bytes_of_rolling_strips : bytes_of_strips);
        product += seconds_of_pair * pairs_of_strips(grid);
    }
    const double steps = rolls ? friction->at("rolling").value("steps", 1.0) : 1;
    const double products =
        friction != nullptr ? products_of_friction + products_of_step * (steps - 1) : products_of_normal;
    double seconds = product * products;
    if (any_body(params, "layered")) seconds += seconds_of_layered_offset * elements * (rolls ? 5 : 1);
    return {bytes_beside + bytes + elements * bytes_of_answer, seconds};
}

WorkCost cost_of_solve_many(const json& params, const Config& config) {
    double answers = 0, largest = 0, seconds = 0;
    for (const json& problem : params.at("problems")) {
        const WorkCost cost = cost_of_solve(problem, config);
        answers += 4096 + sides(problem.at("grid")) * bytes_of_answer;
        largest = std::max(largest, cost.bytes);
        seconds += cost.seconds;
    }
    return {answers + config.workers * largest, seconds};
}

WorkCost cost_of_subsurface(const json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const double elements = sides(params.at("grid"));
    double points = 1, offsets = 0, corners = 0;
    if (const json* block = member(params, "block")) {
        std::array<double, 3> along{1, 1, 1};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            along[axis] = length_of(block->at(std::array{"x", "y", "z"}[axis]));
        }
        points = along[0] * along[1] * along[2];
        offsets = (along[0] + params.at("grid").at("nx").get<double>()) *
                  (along[1] + params.at("grid").at("ny").get<double>());
        // Corners of points in rows of whole elements; others are summed up one by one, and look at their deadline.
        corners = 3 * along[2] * std::min(offsets, along[0] * along[1] * elements);
    } else if (const json* list = member(params, "points")) {
        points = length_of(*list);
        corners = points * elements;
    }
    const bool layered = any_body(params, "layered");
    const double per_offset = layered ? 4 * bytes_of_offset : bytes_of_offset;
    return {bytes_beside + elements * 100 + points * bytes_of_stress + std::min(offsets, 16e6) * per_offset,
            corners * (layered ? seconds_of_layered_offset : seconds_of_corner)};
}

WorkCost cost_of_table(const json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const json& grid = params.at("grid");
    const bool is_uniform = any_body(params, "longitudinally_uniform");
    const double offsets = is_uniform ? pairs_of_strips(grid) : sides(grid);
    // The record, the part that is asked for, and the answer.
    const double seconds = any_body(params, "layered") ? seconds_of_layered_offset : seconds_of_offset;
    return {bytes_beside + offsets * 9 * sizeof(double) * 4, offsets * seconds};
}

WorkCost cost_of_export(const json& params, const Config& config) {
    WorkCost cost = cost_of_table(params, config);
    cost.bytes *= 2;  // both bodies, or the file and its copy
    return cost;
}

WorkCost cost_of_import(const json& params, const Config&) {
    double numbers = 0;
    for (const auto& [path, array] : params.at("datasets").items()) numbers += numbers_of(array);
    // The arrays, their record, the closed form that it is compared with, and the file.
    return {bytes_beside + 5 * sizeof(double) * numbers, seconds_of_offset * numbers};
}

WorkCost cost_of_wheel_rail(const json& params, const Config&) {
    constexpr double length = 20, width = 20;  // mm, of a contact with its margin
    constexpr double most = 200'000;
    const json none = json::object();
    const json* given = member(params, "setup");
    const json& setup = given != nullptr ? *given : none;
    const double dx = setup.value("dx", 0.2), dy = setup.value("dy", 0.2);
    const double nx = length / dx, ny = width / dy, elements = std::min(nx * ny, most);
    double bytes = elements * (bytes_of_rolling + bytes_of_answer);
    const std::string conformal = setup.value("conformal", "off");
    if (conformal != "off") bytes += elements * std::min(ny, 1000.0) * bytes_of_rolling_strips;
    const double product = seconds_of_product * elements * std::log2(4 * elements + 2);
    return {bytes_beside + 2 * bytes, 2 * product * products_of_wheel};
}

WorkCost cost_of_geometry(const json& params, const Config&) {
    const auto count = [](const json* object, const char* list) {
        const json* values = object != nullptr ? member(*object, list) : nullptr;
        return values != nullptr ? static_cast<double>(values->size()) : 0;
    };
    const double positions = count(&params, "states") + count(member(params, "contacts"), "shifts"),
                 amplitudes = count(member(params, "conicity"), "amplitudes");
    return {10 * bytes_beside + 1e4 * positions, seconds_of_position * positions + seconds_of_amplitude * amplitudes};
}

WorkCost cost_of_opening(const json& params, const Config& config) {
    const json* wheel_rail = member(params, "wheelrail");
    return wheel_rail != nullptr ? cost_of_wheel_rail(*wheel_rail, config) : cost_of_solve(params, config);
}

bool is_large(double seconds) {
    return seconds > 1;
}

void check_cost(const WorkCost& cost, const Config& config) {
    const auto refuse = [](double is, const char* unit, double limit, const char* name, const char* cure) {
        const auto text = [](double value) { return std::to_string(static_cast<long long>(std::ceil(value))); };
        throw proto::StatusError(proto::StatusCode::invalid_argument, proto::reason::limit_exceeded,
                                 "The request would take about " + text(is) + " " + unit + "; at most " + text(limit) +
                                     " are allowed (limits." + name + "). " + cure);
    };
    if (cost.bytes > static_cast<double>(config.max_work_bytes))
        refuse(cost.bytes, "bytes of memory", static_cast<double>(config.max_work_bytes), "max_work_bytes",
               "Take fewer elements, fewer strips of a longitudinally uniform body, or less at once.");
    if (cost.seconds > config.max_work_seconds)
        refuse(cost.seconds, "s of a processor", config.max_work_seconds, "max_work_seconds",
               "Take fewer elements, or less at once.");
}

}  // namespace contactd::server

#include "costs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/proto/status.hpp"
#include "contactd/strip_memory.hpp"
#include "cost_parts.hpp"
#include "request_limits.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

// These are bytes for each element, measured as the growth of a daemon; tests/integration/test_bounds.py checks them.
constexpr double bytes_of_normal = 600;          // normal contact: a table, its symbols, and arrays of the solver
constexpr double bytes_of_tangential = 1700;     // friction, too
constexpr double bytes_of_rolling = 2600;        // in addition, the changes over a step of rolling
constexpr double bytes_of_simplified = 400;      // closed forms, which have fields and no operators
constexpr double bytes_of_answer = 150;          // all fields, as arrays of an answer and its frames
constexpr double bytes_of_displacements = 100;   // the same, and the arrays that are summed
constexpr double bytes_of_derivatives = 1000;    // with friction: steps of their linear equations
constexpr double bytes_of_friction_state = 500;  // the state of layers and memory, and its arrays in an answer
// Viscoelastic bodies have tables of offsets of both signs, their symbols, and directions of the normal problem.
constexpr double bytes_of_creep = 3000;

// These are measured seconds: a product by FFT takes the first time for each element and power of two of their number,
// a product with strips the second time for each pair. The stated cost is 1.5 to 3 times that of most requests, because
// some need more products.
constexpr double seconds_of_product = 6e-9, seconds_of_pair = 2.4e-8;
constexpr double products_of_normal = 15, products_of_friction = 200, products_of_step = 50;
constexpr double products_of_wheel = 100;  // including the search for its height

double pairs_of_strips(const json& grid) {
    return elements_of(grid) * grid.at("ny").get<double>();
}

/// Adds the grids from which forces are extrapolated, each with a quarter of the elements of the next finer one. Their
/// operators stay in memory together. Few contacts need the finest grid for a coarse accuracy.
void add_extrapolation(double accuracy, WorkCost& cost) {
    constexpr double finest = 144 * 288, usual = 72 * 144, usual_accuracy = 2e-3, all = 4.0 / 3;
    const double elements = accuracy < usual_accuracy ? finest : usual;
    cost.bytes += all * finest * bytes_of_rolling;
    cost.seconds += all * seconds_of_product * elements * std::log2(4 * elements) * products_of_friction;
}

/// Returns the step of rolling along x; by default the size of an element.
StripRolling step_along_x(const json& params) {
    const json* friction = member(params, "friction");
    const json* rolling = friction != nullptr ? member(*friction, "rolling") : nullptr;
    if (rolling == nullptr) return StripRolling::none;
    const double dq = rolling->value("dq", 0.0);
    return dq == 0 ? StripRolling::whole : strip_rolling(dq / params.at("grid").at("dx").get<double>());
}

}  // namespace

WorkCost cost_of_solve(const json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const json& grid = params.at("grid");
    const double elements = elements_of(grid);
    if (params.value("model", "full") != "full")
        return {bytes_beside + elements * (bytes_of_simplified + bytes_of_answer), 1e-6 * elements};
    const json* friction = member(params, "friction");
    const bool rolls = friction != nullptr && friction->contains("rolling");
    double bytes = elements * (rolls ? bytes_of_rolling : friction != nullptr ? bytes_of_tangential : bytes_of_normal);
    double product = seconds_of_product * elements * std::log2(4 * elements + 2);
    if (const int tables = count_bodies(params, "longitudinally_uniform"); tables > 0) {
        bytes += strip_bytes(pairs_of_strips(grid), tables, step_along_x(params));
        product += seconds_of_pair * pairs_of_strips(grid);
    }
    const double steps = rolls ? friction->at("rolling").value("steps", 1.0) : 1;
    const double products =
        friction != nullptr ? products_of_friction + products_of_step * (steps - 1) : products_of_normal;
    double seconds = product * products;
    if (const json* regions = member(params, "regions"))  // a product of each
        seconds += product * products_of_normal * static_cast<double>(regions->at("limits").size() - 1);
    if (any_body(params, "layered")) seconds += seconds_of_layered_offset * elements * (rolls ? 5 : 1);
    if (any_viscoelastic(params)) {
        bytes += elements * bytes_of_creep;
        seconds += elements * seconds_of_creep;
    }
    const json* kinetic = friction != nullptr ? member(*friction, "kinetic") : nullptr;
    if (friction != nullptr && (friction->contains("layer") || (kinetic != nullptr && kinetic->contains("memory"))))
        bytes += elements * bytes_of_friction_state;
    if (friction != nullptr && params.value("derivatives", false)) bytes += elements * bytes_of_derivatives;
    if (params.value("displacements", false)) bytes += elements * bytes_of_displacements;
    WorkCost cost{bytes_beside + bytes + elements * bytes_of_answer, seconds};
    if (const json* accuracy = member(params, "accuracy")) add_extrapolation(accuracy->get<double>(), cost);
    return cost;
}

WorkCost cost_of_solve_many(const json& params, const Config& config) {
    double answers = 0, largest = 0, seconds = 0;
    for (const json& problem : params.at("problems")) {
        const WorkCost cost = cost_of_solve(problem, config);
        answers += 4096 + elements_of(problem.at("grid")) * bytes_of_answer;
        largest = std::max(largest, cost.bytes);
        seconds += cost.seconds;
    }
    return {answers + config.workers * largest, seconds};
}

WorkCost cost_of_table(const json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const json& grid = params.at("grid");
    const bool is_uniform = any_body(params, "longitudinally_uniform");
    const double offsets = is_uniform ? pairs_of_strips(grid) : elements_of(grid);
    // Counts the record, the requested part, and the answer.
    const double seconds = any_body(params, "layered") ? seconds_of_layered_offset : seconds_of_offset;
    return {bytes_beside + offsets * 9 * sizeof(double) * 4, offsets * seconds};
}

WorkCost cost_of_export(const json& params, const Config& config) {
    WorkCost cost = cost_of_table(params, config);
    cost.bytes *= 2;  // counts both bodies, or the file and its copy
    return cost;
}

WorkCost cost_of_wheel_rail(const json& params, const Config& config) {
    constexpr double length = 20, width = 20;  // mm, for a contact with its margin
    constexpr double most = 200'000;
    const json none = json::object();
    const json* given = member(params, "setup");
    const json& setup = given != nullptr ? *given : none;
    const double dx = setup.value("dx", 0.2), dy = setup.value("dy", 0.2);
    const double nx = length / dx, ny = width / dy, elements = std::min(nx * ny, most);
    double bytes = elements * (bytes_of_rolling + bytes_of_answer);
    // Rows of half-spaces that lie flat, or along the loaded row, have the coefficients of one.
    if (const std::string conformal = setup.value("conformal", "off"); conformal == "fem") {
        constexpr int tables = 3;
        const double dq = setup.value("dq", 0.0);  // 0: an element
        bytes += strip_bytes(nx * ny * ny, tables, strip_rolling(dq > 0 ? dq / dx : 1));
    } else if (conformal == "rotated" || conformal == "auto") {
        bytes += rotated_bytes(elements, elements * ny);
    }
    const double product = seconds_of_product * elements * std::log2(4 * elements + 2);
    // A patch is rarely as large as this estimate, which refuses nothing. The actual size is checked once it is known.
    return {std::min(bytes_beside + 2 * bytes, static_cast<double>(config.max_work_bytes)),
            2 * product * products_of_wheel};
}

bool is_large(double seconds) {
    return seconds > 1;
}

void check_cost(const WorkCost& cost, const Config& config) {
    const auto refuse = [](double is, const char* unit, double limit, const char* name, const char* cure) {
        const auto text = [](double value) { return std::to_string(static_cast<long long>(std::ceil(value))); };
        throw proto::StatusError(proto::StatusCode::invalid_argument, proto::reason::limit_exceeded,
                                 "The request needs about " + text(is) + " " + unit + ", but at most " + text(limit) +
                                     " are allowed (limits." + name + "). " + cure);
    };
    if (cost.bytes > static_cast<double>(config.max_work_bytes))
        refuse(cost.bytes, "bytes of memory", static_cast<double>(config.max_work_bytes), "max_work_bytes",
               "Use fewer elements, fewer strips of a longitudinally uniform body, or fewer problems at once.");
    if (cost.seconds > config.max_work_seconds)
        refuse(cost.seconds, "s of processor time", config.max_work_seconds, "max_work_seconds",
               "Use fewer elements, or fewer problems at once.");
}

}  // namespace contactd::server

#include "cost_examples.hpp"

#include <array>
#include <string>

#include "all_methods.hpp"
#include "methods/costs/costs.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

struct Example {
    const char* method;
    const char* arguments;
    json params;
};

json grid(int nx, int ny, double size) {
    return {{"nx", nx}, {"ny", ny}, {"dx", size / nx}, {"dy", size / ny}};
}

/// A ball on a plane that covers about two thirds of the grid.
json ball(int nx, int ny) {
    return {{"grid", grid(nx, ny, 2.4)},
            {"bodies", {{"upper", {{"G", 82000}, {"nu", 0.28}}}, {"lower", {{"G", 820}, {"nu", 0.45}}}}},
            {"ics", {{"source", "analytic"}}},
            {"gap", {{"paraboloid", {{"Rx", 50}, {"Ry", 50}}}}},
            {"approach", 0.02}};
}

json with(json params, const json& more) {
    params.update(more);
    return params;
}

json rolling() {
    return {{"friction", {{"mu", 0.3}, {"rolling", {{"kind", "transient"}, {"xi", 1e-3}, {"dq", 0.0024}}}}}};
}

json slab(int nx, int ny) {
    json params = ball(nx, ny);
    params["bodies"] = {{"upper", {{"rigid", true}}},
                        {"lower",
                         {{"G", 82000},
                          {"nu", 0.28},
                          {"ics",
                           {{"source", "analytic"},
                            {"body", "longitudinally_uniform"},
                            {"section", {{"slab", {{"thickness", 10}, {"width", 100}}}}}}}}}};
    params.erase("ics");
    return params;
}

json along(int count, double from, double to) {
    json values = json::array();
    for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / count);
    return values;
}

json under_a_load(int points) {
    json row = json::array(), rows = json::array();
    for (int i = 0; i < 100; ++i) row.push_back(1);
    for (int i = 0; i < 100; ++i) rows.push_back(row);
    return {{"grid", grid(100, 100, 2.4)},
            {"nu", 0.28},
            {"pressure", rows},
            {"block", {{"x", along(points, -1.2, 1.2)}, {"y", along(points, -1.2, 1.2)}, {"z", {-0.1, -0.2}}}}};
}

json wheel(double element) {
    return {{"setup", {{"dx", element}, {"dy", element}, {"friction", {{"mu", 0.3}}}}}};
}

json positions(int count) {
    json states = json::array();
    for (int i = 0; i < count; ++i) states.push_back({{"position", {{"y", 0.005 * i}}}, {"Fz", 1e5}});
    return states;
}

std::vector<Example> examples() {
    json problems = json::array();
    for (int i = 0; i < 1000; ++i) problems.push_back(with(ball(31, 31), rolling()));
    return {
        {"contact.solve", "1000 x 1000 elements, two materials, rolling", with(ball(1000, 1000), rolling())},
        {"contact.solve", "1000 x 1000 elements, without friction", ball(1000, 1000)},
        {"contact.solve", "a slab (longitudinally uniform) of 30 x 600 elements, without friction", slab(30, 600)},
        {"contact.solve_many", "1000 problems of 31 x 31 elements, rolling", {{"problems", problems}}},
        {"contact.subsurface", "a block of 600 x 600 points at two depths below 100 x 100 elements", under_a_load(600)},
        {"ic.get",
         "a half-space on 1000 x 1000 elements",
         {{"material", {{"G", 82000}, {"nu", 0.28}}},
          {"grid", grid(1000, 1000, 2.4)},
          {"ics", {{"source", "analytic"}}}}},
        {"ic.export",
         "a half-space on 400 x 400 elements, as HDF5",
         {{"material", {{"G", 82000}, {"nu", 0.28}}},
          {"grid", grid(400, 400, 2.4)},
          {"ics", {{"source", "analytic"}}},
          {"format", "hdf5"}}},
        {"wheelrail.solve", "elements of 0.05 mm, with friction",
         with(wheel(0.05), {{"state", {{"Fz", 1e5}, {"velocity", {{"x", 30000}}}}}})},
        {"wheelrail.wheelset", "elements of 0.05 mm, with friction",
         with(wheel(0.05), {{"state", {{"Fz_left", 1e5}, {"Fz_right", 1e5}, {"velocity", {{"x", 30000}}}}}})},
        {"wheelrail.geometry", "1000 positions", {{"setup", {{"dx", 0.2}, {"dy", 0.2}}}, {"states", positions(1000)}}},
        {"session.open", "400 x 400 elements, two materials, rolling", with(ball(400, 400), rolling())}};
}

}  // namespace

json cost_examples(const Config& config) {
    const MethodTable methods = all_methods();
    json all = json::array();
    for (const Example& example : examples()) {
        const Method* method = methods.find(example.method);
        const WorkCost cost = method->cost(example.params, config);
        all.push_back({{"method", example.method},
                       {"arguments", example.arguments},
                       {"bytes", cost.bytes},
                       {"seconds", cost.seconds},
                       {"params", example.params}});
    }
    for (const std::string& name : methods.names())
        if (methods.find(name)->cost == nullptr)
            all.push_back({{"method", name}, {"arguments", "any"}, {"bytes", nullptr}, {"seconds", nullptr}});
    return all;
}

}  // namespace contactd::server

#include "cost_examples.hpp"

#include <string>
#include <utility>

#include "all_methods.hpp"
#include "contactd/proto/schema.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

std::string joined(const json& parts) {
    if (parts.is_string()) return parts.get<std::string>();
    std::string text;
    for (const json& part : parts) text += joined(part);
    return text;
}

/// Expands the abbreviations of x-largest. {"$repeat": n, "of": value} is a list of n copies of `value`. A {"$along":
/// [from, to]} inside `value` becomes a number that varies linearly over the list. {"$joined": [...]} is a text of
/// several parts.
json written_out(const json& node, double along) {
    json whole = node;
    if (node.is_array())
        for (json& entry : whole) entry = written_out(entry, along);
    if (!node.is_object()) return whole;
    if (const auto range = node.find("$along"); range != node.end()) {
        const double from = range->at(0), to = range->at(1);
        return from + (to - from) * along;
    }
    if (const auto count = node.find("$repeat"); count != node.end()) {
        whole = json::array();
        for (int i = 0; i < *count; ++i) whole.push_back(written_out(node.at("of"), i / count->get<double>()));
        return whole;
    }
    if (const auto parts = node.find("$joined"); parts != node.end()) return joined(written_out(*parts, along));
    for (auto& [name, value] : whole.items()) value = written_out(value, along);
    return whole;
}

json example(const Method& method, const json& largest, const Config& config) {
    json params = written_out(largest.at("params"), 0);
    const WorkCost cost = method.cost(params, config);
    return {{"method", method.name},
            {"arguments", largest.at("arguments")},
            {"bytes", cost.bytes},
            {"seconds", cost.seconds},
            {"params", std::move(params)}};
}

}  // namespace

json cost_examples(const Config& config) {
    const MethodTable methods = all_methods();
    json all = json::array(), little = json::array();
    for (const std::string& name : proto::method_names()) {
        const Method& method = *methods.find(name);
        const json& schema = proto::schema(name + ".params");
        if (method.cost == nullptr)
            little.push_back({{"method", name}, {"arguments", "any"}, {"bytes", nullptr}, {"seconds", nullptr}});
        else if (schema.contains("x-largest"))
            for (const json& largest : schema["x-largest"]) all.push_back(example(method, largest, config));
    }
    for (json& method : little) all.push_back(std::move(method));
    return all;
}

}  // namespace contactd::server

#include "cost_parts.hpp"

#include <algorithm>
#include <string>

namespace contactd::server {

using nlohmann::json;

double elements_of(const json& grid) {
    return grid.at("nx").get<double>() * grid.at("ny").get<double>();
}

const json* member(const json& params, const char* name) {
    const auto at = params.find(name);
    return at == params.end() ? nullptr : &*at;
}

namespace {

bool has_kind(const json* body, const char* kind) {
    const json* ics = body != nullptr && body->is_object() ? member(*body, "ics") : nullptr;
    return ics != nullptr && ics->is_object() && ics->value("body", "") == kind;
}

}  // namespace

int count_bodies(const json& params, const char* kind) {
    const json* bodies = member(params, "bodies");
    if (bodies == nullptr) return has_kind(&params, kind) ? 2 : 0;
    const json *upper = member(*bodies, "upper"), *lower = member(*bodies, "lower");
    int count = 0;
    for (const json* body : {upper, lower != nullptr ? lower : upper}) {
        if (body == nullptr || body->value("rigid", false)) continue;
        if (has_kind(body->contains("ics") ? body : &params, kind)) ++count;
    }
    return count;
}

bool any_body(const json& params, const char* kind) {
    const auto is_kind = [&](const json* body) { return has_kind(body, kind); };
    const json* bodies = member(params, "bodies");
    if (bodies == nullptr) return is_kind(&params);
    return is_kind(&params) || is_kind(member(*bodies, "upper")) || is_kind(member(*bodies, "lower"));
}

bool any_viscoelastic(const json& params) {
    const json* bodies = member(params, "bodies");
    if (bodies == nullptr) return false;
    return std::any_of(bodies->begin(), bodies->end(), [](const json& body) { return body.contains("viscoelastic"); });
}

double length_of(const json& array) {
    if (array.is_array()) return static_cast<double>(array.size());
    const json& shape = array.at("$array").at("shape");
    return shape.empty() ? 1 : shape.front().get<double>();
}

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

}  // namespace contactd::server

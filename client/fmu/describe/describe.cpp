// contactd-fmu-description: prints the FMUs as JSON on standard output. Model descriptions, archives and the page
// docs/fmu.md are generated from it (packaging/fmu).
#include <iostream>
#include <nlohmann/json.hpp>

#include "instance/kind.hpp"

namespace {

using nlohmann::ordered_json;
using namespace contactd::fmu;

constexpr const char* types[] = {"real", "integer", "boolean", "enumeration", "text"};
constexpr const char* roles[] = {"time", "parameter", "tunable", "input", "output"};

ordered_json start_of(const Variable& variable) {
    switch (variable.type) {
        case Type::text:
            return variable.text;
        case Type::boolean:
            return variable.start != 0;
        case Type::real:
            return variable.start;
        default:
            return static_cast<int>(variable.start);
    }
}

ordered_json described(const Variable& variable) {
    ordered_json all{{"name", variable.name},
                     {"role", roles[static_cast<int>(variable.role)]},
                     {"type", types[static_cast<int>(variable.type)]},
                     {"unit", variable.unit},
                     {"start", start_of(variable)},
                     {"says", variable.says}};
    if (variable.type == Type::enumeration)
        all["enumeration"] = {{"name", variable.enumeration->name}, {"words", variable.enumeration->keywords}};
    return all;
}

}  // namespace

int main() {
    ordered_json all;
    for (const Unit& unit : units)
        all["units"].push_back({{"name", unit.name},
                                {"factor", unit.factor},
                                {"kg", unit.kg},
                                {"m", unit.m},
                                {"s", unit.s},
                                {"rad", unit.rad},
                                {"K", unit.K},
                                {"offset", unit.offset}});
    for (const Kind& kind : kinds()) {
        ordered_json variables = ordered_json::array();
        for (const Variable& variable : kind.variables) variables.push_back(described(variable));
        all["kinds"].push_back(
            {{"name", kind.name}, {"says", kind.says}, {"token", token_of(kind)}, {"variables", variables}});
    }
    all["version"] = CONTACTD_VERSION;
    std::cout << all.dump(1) << "\n";
}

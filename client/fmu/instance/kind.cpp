#include "kind.hpp"

#include <algorithm>
#include <cstdio>

#include "digest.hpp"
#include "models/contact_model.hpp"
#include "models/wheel_model.hpp"
#include "variables/contact_variables.hpp"
#include "variables/wheel_variables.hpp"

namespace contactd::fmu {

std::span<const Kind> kinds() {
    static const Kind all[] = {
        {"contactd_contact", "Elastic contact of two bodies on a grid: pressures, tractions and forces",
         contact_variables,
         [](Tell tell, const std::filesystem::path&) -> std::unique_ptr<Model> {
             return std::make_unique<ContactModel>(std::move(tell));
         }},
        {"contactd_wheel", "A railway wheel on its rail: from position and velocity to contact forces", wheel_variables,
         [](Tell tell, const std::filesystem::path& resources) -> std::unique_ptr<Model> {
             return std::make_unique<WheelModel>(std::move(tell), resources);
         }},
    };
    return all;
}

std::string token_of(const Kind& kind) {
    Digest digest;
    digest.add(kind.name);
    for (const Variable& variable : kind.variables) {
        digest.add(variable.name);
        digest.add(std::to_string(static_cast<int>(variable.type)));
        digest.add(std::to_string(static_cast<int>(variable.role)));
    }
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(digest.value()));
    return "{" + std::string(kind.name) + "-" + digits + "}";
}

const Kind* kind_with(std::string_view token) {
    const auto found = std::ranges::find_if(kinds(), [&](const Kind& kind) { return token_of(kind) == token; });
    return found == kinds().end() ? nullptr : &*found;
}

}  // namespace contactd::fmu

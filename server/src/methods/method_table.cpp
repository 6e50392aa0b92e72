#include "method_table.hpp"

namespace contactd::server {

const Method* MethodTable::find(std::string_view name) const {
    const auto at = methods_.find(name);
    return at == methods_.end() ? nullptr : &at->second;
}

std::vector<std::string> MethodTable::names() const {
    std::vector<std::string> names;
    for (const auto& [name, method] : methods_) names.emplace_back(name);
    return names;
}

}  // namespace contactd::server

#include "builder_environment.hpp"

#include <unistd.h>

#include <algorithm>
#include <string_view>

namespace contactd::engine {
namespace {

bool matches(std::string_view variable, std::string_view name) {
    if (name.ends_with('*')) return variable.starts_with(name.substr(0, name.size() - 1));
    return variable == name;
}

}  // namespace

Environment passed_on(const std::vector<std::string>& names) {
    Environment environment;
    for (char** entry = environ; entry && *entry; ++entry) {
        const std::string_view text = *entry;
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos) continue;
        const std::string_view variable = text.substr(0, equals);
        if (std::any_of(names.begin(), names.end(), [&](const auto& name) { return matches(variable, name); }))
            environment.emplace_back(variable, text.substr(equals + 1));
    }
    return environment;
}

}  // namespace contactd::engine

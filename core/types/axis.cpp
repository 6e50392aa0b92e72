#include "contactd/axis.hpp"

#include <cstddef>

namespace contactd {

std::string_view name_of(Axis value) {
    return std::string_view("xyz").substr(static_cast<std::size_t>(value), 1);
}

bool from_name(std::string_view name, Axis& value) {
    const auto at = std::string_view("xyz").find(name);
    if (name.size() != 1 || at == std::string_view::npos) return false;
    value = static_cast<Axis>(at);
    return true;
}

Parity parity(Axis displacement, Axis load) {
    const auto involves = [&](Axis axis) { return (displacement == axis) != (load == axis); };
    return {involves(Axis::x) ? -1 : 1, involves(Axis::y) ? -1 : 1};
}

}  // namespace contactd

// Values by their names.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace contactd {

template <class Value>
using ByName = std::map<std::string, Value, std::less<>>;

}  // namespace contactd

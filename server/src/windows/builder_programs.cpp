// On Windows, tables by finite elements come from a store that a builder on Linux filled. Requests for other tables are
// refused with this reason.
#include "operation/builder_programs.hpp"

namespace contactd::server {

std::string builder_problem(const Config&) {
    return {};
}

std::string launcher_problem(const Config&) {
    return {};
}

std::vector<std::string> building_problems(const Config&) {
    return {};
}

}  // namespace contactd::server

// Versions that the service was made from: a result that is kept must be able to name them.
#pragma once

#include <map>
#include <string>

namespace contactd::server {

/// The commit of the sources, with "-dirty" when they were changed after it; "unknown" when built outside of a
/// repository.
std::string commit();

/// Name -> version, of what the service links.
std::map<std::string, std::string> service_library_versions();

/// "1.2.3"
template <class... Numbers>
std::string dotted(int first, Numbers... rest) {
    return (std::to_string(first) + ... + ("." + std::to_string(rest)));
}

}  // namespace contactd::server

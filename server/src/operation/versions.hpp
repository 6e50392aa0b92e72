// Provides versions of the service and its libraries, which stored results can record.
#pragma once

#include <map>
#include <string>

namespace contactd::server {

/// Returns the commit of the sources, with "-dirty" if they were changed after it; "unknown" if built outside a
/// repository.
std::string commit();

/// Returns name -> version of the linked libraries.
std::map<std::string, std::string> service_library_versions();

/// "1.2.3"
template <class... Numbers>
std::string dotted(int first, Numbers... rest) {
    return (std::to_string(first) + ... + ("." + std::to_string(rest)));
}

}  // namespace contactd::server

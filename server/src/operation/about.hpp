// Versions that this daemon was made from.
#pragma once

#include <map>
#include <string>

namespace contactd::server {

/// Name -> version, of everything the daemon links.
std::map<std::string, std::string> daemon_library_versions();

/// The text that --version prints.
std::string about();

}  // namespace contactd::server

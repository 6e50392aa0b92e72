// Provides versions of this daemon and its libraries.
#pragma once

#include <map>
#include <string>

namespace contactd::server {

/// Returns name -> version of all linked libraries.
std::map<std::string, std::string> daemon_library_versions();

/// Returns the text that --version prints.
std::string about();

}  // namespace contactd::server

// What this daemon was made from: a result that is kept must be able to say so.
#pragma once

#include <map>
#include <string>

namespace contactd::server {

/// Of the sources, with "-dirty" when they were changed after it; "unknown" when it was built outside of a repository.
std::string commit();

/// Name -> version, of everything the daemon links.
std::map<std::string, std::string> all_library_versions();

/// What --version prints.
std::string about();

}  // namespace contactd::server

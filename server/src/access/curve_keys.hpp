// Reads and creates keys of CURVE: the daemon's own, and those of its users.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace contactd::server {

/// Holds the public keys (Z85) of allowed users with the users' names, which are the names of the files.
class AllowedKeys {
   public:
    /// Returns the user with this key, or an empty text.
    std::string user_of(const std::string& public_key) const;
    bool has_user(const std::string& name) const;
    std::size_t size() const { return users_.size(); }

    /// Reads every NAME.key of the folder. A file that cannot be used is skipped and listed in `problems`. Throws Error
    /// if the folder cannot be read.
    static AllowedKeys read(const std::filesystem::path& folder, std::vector<std::string>& problems);

   private:
    std::map<std::string, std::string> users_;  // by key
};

/// Returns the secret key (Z85) from the daemon's own file. Throws Error, also if other users can read the file.
std::string read_secret_key(const std::filesystem::path& path);

struct NewKeys {
    std::filesystem::path secret_file, public_file;
};

/// Creates a pair of keys and writes FOLDER/NAME.key_secret, readable by its owner only, and FOLDER/NAME.key. Creates
/// the folder if it is missing. Throws Error if the name is not valid for a file or one of the files exists; files are
/// never overwritten.
NewKeys generate_keys(const std::filesystem::path& folder, const std::string& name);

}  // namespace contactd::server

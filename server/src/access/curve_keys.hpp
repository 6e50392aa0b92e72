// The keys of CURVE: the daemon's own, those of its users, and new ones.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace contactd::server {

/// Public keys (Z85) of those who may connect, and the names of their users, which are the names of the files.
class AllowedKeys {
   public:
    /// The user with this key; empty when there is none.
    std::string user_of(const std::string& public_key) const;
    bool has_user(const std::string& name) const;
    std::size_t size() const { return users_.size(); }

    /// Reads every NAME.key of the folder. A file that cannot be used is left out and named in `problems`. Throws Error
    /// when the folder cannot be read.
    static AllowedKeys read(const std::filesystem::path& folder, std::vector<std::string>& problems);

   private:
    std::map<std::string, std::string> users_;  // by key
};

/// The secret key (Z85) in the daemon's own file. Throws Error, also when others can read the file.
std::string read_secret_key(const std::filesystem::path& path);

struct NewKeys {
    std::filesystem::path secret_file, public_file;
};

/// Makes a pair of keys and writes FOLDER/NAME.key_secret, readable by its owner only, and FOLDER/NAME.key; makes the
/// folder when it is missing. Throws Error when the name is no file name or one of the files exists; nothing is ever
/// overwritten.
NewKeys generate_keys(const std::filesystem::path& folder, const std::string& name);

}  // namespace contactd::server

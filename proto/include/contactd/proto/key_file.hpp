// Files with CURVE keys, in the form of CZMQ's and pyzmq's certificates:
//
//     metadata
//         name = "alice"
//     curve
//         public-key = "..."
//         secret-key = "..."
//
// Keys are written in Z85, 40 characters. A file without secret-key is a public one and may be given to anybody.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace contactd::proto {

struct KeyFile {
    std::string public_key;  ///< Z85
    std::string secret_key;  ///< Z85; empty in a public file
};

/// Reads the content of a key file. Throws contactd::Error saying what is missing or wrong, never quoting the content.
KeyFile parse_key_file(std::string_view text);

/// Reads a key file, as parse_key_file does its content. Errors begin with the path; what is no ordinary file, or
/// larger than a key file can be, is refused before it is read.
KeyFile read_key_file(const std::filesystem::path& path);

/// Throws Error, naming the path, when others than the file's owner can read or write it.
void check_private(const std::filesystem::path& path);

}  // namespace contactd::proto

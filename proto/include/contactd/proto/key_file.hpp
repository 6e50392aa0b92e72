// Reads and writes files with CURVE keys, in the format of CZMQ's and pyzmq's certificates:
//
//     metadata
//         name = "alice"
//     curve
//         public-key = "..."
//         secret-key = "..."
//
// Keys are written in Z85, 40 characters. A file without secret-key is public and may be distributed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace contactd::proto {

struct KeyFile {
    std::string public_key;  ///< Z85
    std::string secret_key;  ///< Z85; empty in a public file
};

/// Reads the content of a key file. Throws contactd::Error naming the error, without quoting the content.
KeyFile parse_key_file(std::string_view text);

/// Reads a key file with parse_key_file. Errors begin with the path. A file that is not regular, or too large, is
/// refused before it is read.
KeyFile read_key_file(const std::filesystem::path& path);

/// Throws Error, naming the path, if users other than the owner can read or write the file.
void check_private(const std::filesystem::path& path);

}  // namespace contactd::proto

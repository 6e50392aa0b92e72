// SHA-256 as lower-case hex.
#pragma once

#include <span>
#include <string>

namespace contactd {

/// By libsodium; on Windows by the system.
std::string sha256_hex(std::span<const unsigned char> bytes);

}  // namespace contactd

// Computes SHA-256 as lower-case hex.
#pragma once

#include <span>
#include <string>

namespace contactd {

/// Uses libsodium, or the system's implementation on Windows.
std::string sha256_hex(std::span<const unsigned char> bytes);

}  // namespace contactd

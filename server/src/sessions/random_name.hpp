// Creates names that cannot be guessed, because they give access.
#pragma once

#include <array>
#include <string>

#include "contactd/platform.hpp"

namespace contactd::server {

/// Returns 128 random bits in hexadecimal.
inline std::string random_name() {
    std::array<unsigned char, 16> bytes{};
    platform::random_bytes(bytes);
    constexpr const char* digits = "0123456789abcdef";
    std::string name;
    for (const unsigned char byte : bytes) {
        name += digits[byte >> 4u];
        name += digits[byte & 15u];
    }
    return name;
}

}  // namespace contactd::server

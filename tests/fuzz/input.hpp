// Converts the bytes of a fuzzer to a message: text up to the first zero byte, followed by frames, each with two bytes
// of length (little-endian) and its bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

struct Input {
    std::string_view text;
    std::vector<std::string> frames;
};

inline std::string_view bytes_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

inline Input split(std::string_view bytes) {
    Input input;
    const std::size_t end = bytes.find('\0');
    input.text = bytes.substr(0, end);
    if (end == std::string_view::npos) return input;
    bytes.remove_prefix(end + 1);
    while (bytes.size() >= 2) {
        const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(bytes[n]); };
        const std::size_t length = byte(0) + 256u * byte(1);
        input.frames.emplace_back(bytes.substr(2, length));
        bytes.remove_prefix(std::min(2 + length, bytes.size()));
    }
    return input;
}

/// Ends the program if `holds` is false; a fuzzer keeps such an input.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

}  // namespace fuzz

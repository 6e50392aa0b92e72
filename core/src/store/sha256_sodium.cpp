#include <sodium.h>

#include <array>

#include "sha256.hpp"

namespace contactd {

std::string sha256_hex(std::span<const unsigned char> bytes) {
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash;
    crypto_hash_sha256(hash.data(), bytes.data(), bytes.size());
    std::string text(2 * hash.size() + 1, '\0');
    sodium_bin2hex(text.data(), text.size(), hash.data(), hash.size());
    text.pop_back();  // the terminating zero
    return text;
}

}  // namespace contactd

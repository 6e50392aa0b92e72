#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <bcrypt.h>

#include <algorithm>
#include <array>

#include "contactd/error.hpp"
#include "sha256.hpp"

namespace contactd {
namespace {

void check(NTSTATUS status) {
    if (status < 0) throw Error("Windows cannot compute a SHA-256.");
}

}  // namespace

std::string sha256_hex(std::span<const unsigned char> bytes) {
    struct Provider {
        BCRYPT_ALG_HANDLE handle = nullptr;
        Provider() { check(::BCryptOpenAlgorithmProvider(&handle, BCRYPT_SHA256_ALGORITHM, nullptr, 0)); }
    };
    static const Provider sha256;  // It lives as long as the process.
    std::array<unsigned char, 32> hash;
    BCRYPT_HASH_HANDLE begun = nullptr;
    check(::BCryptCreateHash(sha256.handle, &begun, nullptr, 0, nullptr, 0, 0));
    constexpr std::size_t most = 1u << 30;
    NTSTATUS status = 0;
    while (!bytes.empty() && status >= 0) {
        const std::span<const unsigned char> part = bytes.first(std::min(most, bytes.size()));
        status = ::BCryptHashData(begun, const_cast<unsigned char*>(part.data()), static_cast<ULONG>(part.size()), 0);
        bytes = bytes.subspan(part.size());
    }
    if (status >= 0) status = ::BCryptFinishHash(begun, hash.data(), static_cast<ULONG>(hash.size()), 0);
    ::BCryptDestroyHash(begun);
    check(status);
    std::string text;
    for (const unsigned char byte : hash) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
    return text;
}

}  // namespace contactd

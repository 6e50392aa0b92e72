#include "global_heap.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "contactd/ic_store.hpp"

namespace contactd {
namespace {

constexpr std::array<unsigned char, 5> signature{'G', 'C', 'O', 'L', 1};
constexpr std::size_t block_header_size = 16;  // header of a collection, and of an object

std::uint64_t number_at(std::span<const unsigned char> image, std::size_t at, std::size_t bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = bytes; i-- > 0;) number = number << 8u | image[at + i];
    return number;
}

/// Returns the bytes up to the next object. The object of index 0 is free space, whose size includes its header.
std::uint64_t room_of(std::uint64_t index, std::uint64_t size) {
    constexpr std::uint64_t aligned = 7;
    return index == 0 ? size : block_header_size + ((size + aligned) & ~aligned);
}

void check_collection(std::span<const unsigned char> image, std::size_t begin) {
    if (image.size() - begin < block_header_size) return;
    const std::size_t end = begin + std::min<std::uint64_t>(number_at(image, begin + 8, 8), image.size() - begin);
    for (std::size_t at = begin + block_header_size; at + block_header_size <= end;) {
        const std::uint64_t room = room_of(number_at(image, at, 2), number_at(image, at + 8, 8));
        if (room == 0)
            throw DamagedTable("The heap at " + std::to_string(begin) +
                               " of the file contains an object of invalid size.");
        if (room > end - at) return;
        at += room;
    }
}

}  // namespace

void check_global_heaps(std::span<const unsigned char> image) {
    for (auto at = image.begin();; ++at) {
        at = std::search(at, image.end(), signature.begin(), signature.end());
        if (at == image.end()) return;
        check_collection(image, static_cast<std::size_t>(at - image.begin()));
    }
}

}  // namespace contactd

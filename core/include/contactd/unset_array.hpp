// Arrays whose memory nobody touches before it is written.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace contactd {

/// Leaves what is given no value as it is found. Zeros that are overwritten anyway cost a large table a quarter of its
/// time: the system hands out memory page by page, when it is touched first.
template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    template <class U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

/// `UnsetArray(n)` and `resize(n)` set nothing; `UnsetArray(n, 0.0)` does.
using UnsetArray = std::vector<double, UnsetAllocator<double>>;

}  // namespace contactd

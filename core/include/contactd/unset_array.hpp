// Defines arrays whose memory is not touched before it is written.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace contactd {

/// Leaves values without initializers unset. Unneeded zeros would take a quarter of the time of a large table, because
/// the system allocates memory page by page on the first access.
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

/// `UnsetArray(n)` and `resize(n)` leave values unset; `UnsetArray(n, 0.0)` sets them.
using UnsetArray = std::vector<double, UnsetAllocator<double>>;

}  // namespace contactd

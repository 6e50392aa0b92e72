// Caches operators on boxes of elements, for the last few sizes.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "contactd/element_box.hpp"

namespace contactd {

/// The cache is safe to use from several threads at once.
template <class Operator>
class CachedBoxes {
   public:
    template <class Make>
    std::shared_ptr<const Operator> get(const ElementBox& box, const Make& make) {
        const std::scoped_lock lock(mutex_);
        for (const auto& entry : cache_)
            if (entry.box == box) return entry.made;
        if (cache_.size() == most_cached) cache_.pop_front();
        cache_.push_back({box, make()});
        return cache_.back().made;
    }

   private:
    static constexpr std::size_t most_cached = 8;
    struct Entry {
        ElementBox box;
        std::shared_ptr<const Operator> made;
    };
    std::mutex mutex_;
    std::deque<Entry> cache_;  // the oldest first
};

}  // namespace contactd

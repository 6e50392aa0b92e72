// Operators on boxes of elements, of which the last few sizes are kept.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "contactd/element_box.hpp"

namespace contactd {

/// Safe to use from several threads at once.
template <class Operator>
class KeptBoxes {
   public:
    template <class Make>
    std::shared_ptr<const Operator> get(const ElementBox& box, const Make& make) {
        const std::scoped_lock lock(mutex_);
        for (const auto& kept : kept_)
            if (kept.box == box) return kept.made;
        if (kept_.size() == most_kept) kept_.pop_front();
        kept_.push_back({box, make()});
        return kept_.back().made;
    }

   private:
    static constexpr std::size_t most_kept = 8;
    struct Kept {
        ElementBox box;
        std::shared_ptr<const Operator> made;
    };
    std::mutex mutex_;
    std::deque<Kept> kept_;  // the oldest first
};

}  // namespace contactd

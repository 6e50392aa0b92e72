// Keeps values in memory. If the budget is full, the least recently used ones are removed first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace contactd::engine {

/// Thread-safe. Several values may have one key, and there are few enough for a linear search. `Value` is cheap to
/// copy: a shared pointer, or a struct of them.
template <class Value>
class LeastRecentlyUsed {
   public:
    explicit LeastRecentlyUsed(std::size_t budget_bytes) : budget_(budget_bytes) {}

    /// Returns a value with this key that `serves`, or nothing.
    template <class Serves>
    std::optional<Value> find(const std::string& key, const Serves& serves) {
        const std::scoped_lock lock(mutex_);
        const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& e) { return e.key == key && serves(e.value); });
        if (entry == entries_.end()) return std::nullopt;
        entries_.splice(entries_.begin(), entries_, entry);
        return entry->value;
    }

    /// Stores a value of `bytes` instead of those with this key that it `replaces`, unless it exceeds the budget.
    template <class Replaces>
    void insert(const std::string& key, Value value, std::size_t bytes, const Replaces& replaces) {
        if (bytes > budget_) return;
        const std::scoped_lock lock(mutex_);
        erase_if(key, replaces);
        while (bytes_ + bytes > budget_) {
            bytes_ -= entries_.back().bytes;
            entries_.pop_back();
        }
        entries_.push_front({key, std::move(value), bytes});
        bytes_ += bytes;
    }

    void remove(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        erase_if(key, [](const Value&) { return true; });
    }

    struct Usage {
        std::size_t entries = 0;
        std::size_t bytes = 0;
        std::size_t budget_bytes = 0;
    };
    Usage usage() const {
        const std::scoped_lock lock(mutex_);
        return {entries_.size(), bytes_, budget_};
    }

   private:
    struct Entry {
        std::string key;
        Value value;
        std::size_t bytes;
    };

    template <class Goes>
    void erase_if(const std::string& key, const Goes& goes) {
        std::erase_if(entries_, [&](const Entry& entry) {
            if (entry.key != key || !goes(entry.value)) return false;
            bytes_ -= entry.bytes;
            return true;
        });
    }

    const std::size_t budget_;
    mutable std::mutex mutex_;
    std::list<Entry> entries_;  // most recently used first
    std::size_t bytes_ = 0;
};

}  // namespace contactd::engine

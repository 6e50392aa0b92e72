// Dimensionless tables in memory, the least recently used going first when the budget is full.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"

namespace contactd::server {

class IcCache {
   public:
    using Record = std::shared_ptr<const IcRecord>;

    explicit IcCache(std::size_t budget_bytes) : budget_(budget_bytes) {}

    /// A table with this key that covers the extent, or null.
    Record find(const std::string& key, int nx, int ny);
    /// Keeps the record when it fits the budget, all tables of a family counted; tables that it covers go.
    void insert(const std::string& key, Record record);

    void remove(const std::string& key);

    struct Usage {
        std::size_t tables = 0;
        std::size_t bytes = 0;
        std::size_t budget_bytes = 0;
    };
    Usage usage() const;

   private:
    struct Entry {
        std::string key;
        Record record;
        std::size_t bytes;
    };

    const std::size_t budget_;
    mutable std::mutex mutex_;
    std::list<Entry> entries_;  // most recently used first; few enough to search through
    std::size_t bytes_ = 0;
};

}  // namespace contactd::server

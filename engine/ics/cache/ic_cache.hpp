// Caches dimensionless tables in memory. If the budget is full, the least recently used ones are removed first.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "contactd/ic_store.hpp"
#include "least_recently_used.hpp"

namespace contactd::engine {

class IcCache {
   public:
    using Record = std::shared_ptr<const IcRecord>;

    explicit IcCache(std::size_t budget_bytes) : records_(budget_bytes) {}

    /// Returns a table with this key that covers the extent, or null.
    Record find(const std::string& key, int nx, int ny);
    /// Stores the record if it fits the budget, counting all tables of a family, and removes tables that it covers.
    void insert(const std::string& key, Record record);

    void remove(const std::string& key) { records_.remove(key); }

    using Usage = LeastRecentlyUsed<Record>::Usage;
    Usage usage() const { return records_.usage(); }

   private:
    LeastRecentlyUsed<Record> records_;
};

}  // namespace contactd::engine

// Dimensionless tables in memory, the least recently used going first when the budget is full.
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

    /// A table with this key that covers the extent, or null.
    Record find(const std::string& key, int nx, int ny);
    /// Keeps the record when it fits the budget, all tables of a family counted; tables that it covers go.
    void insert(const std::string& key, Record record);

    void remove(const std::string& key) { records_.remove(key); }

    using Usage = LeastRecentlyUsed<Record>::Usage;
    Usage usage() const { return records_.usage(); }

   private:
    LeastRecentlyUsed<Record> records_;
};

}  // namespace contactd::engine

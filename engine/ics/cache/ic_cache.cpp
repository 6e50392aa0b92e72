#include "ic_cache.hpp"

#include <utility>

namespace contactd::engine {

IcCache::Record IcCache::find(const std::string& key, int nx, int ny) {
    const auto covers = [&](const Record& cached) { return extent_of(cached->tables).covers({nx, ny}); };
    return records_.find(key, covers).value_or(nullptr);
}

void IcCache::insert(const std::string& key, Record record) {
    const std::size_t bytes = bytes_of(record->tables);
    const auto is_covered = [extent = extent_of(record->tables)](const Record& cached) {
        return extent.covers(extent_of(cached->tables));
    };
    records_.insert(key, std::move(record), bytes, is_covered);
}

}  // namespace contactd::engine

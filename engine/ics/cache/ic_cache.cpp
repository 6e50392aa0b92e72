#include "ic_cache.hpp"

#include <utility>

namespace contactd::engine {

IcCache::Record IcCache::find(const std::string& key, int nx, int ny) {
    const auto covers = [&](const Record& held) { return extent_of(held->tables).covers({nx, ny}); };
    return records_.find(key, covers).value_or(nullptr);
}

void IcCache::insert(const std::string& key, Record record) {
    const std::size_t bytes = bytes_of(record->tables);
    const auto is_covered = [extent = extent_of(record->tables)](const Record& held) {
        return extent.covers(extent_of(held->tables));
    };
    records_.insert(key, std::move(record), bytes, is_covered);
}

}  // namespace contactd::engine

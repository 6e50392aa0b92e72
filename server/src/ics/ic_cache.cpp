#include "ic_cache.hpp"

#include <utility>

#include "store_keeper.hpp"

namespace contactd::server {

IcCache::Record IcCache::find(const std::string& key, int nx, int ny) {
    const auto covers = [&](const Record& held) { return held->table.nx >= nx && held->table.ny >= ny; };
    return records_.find(key, covers).value_or(nullptr);
}

void IcCache::insert(const std::string& key, Record record) {
    const std::size_t bytes = bytes_of(*record);
    const auto is_covered = [nx = record->table.nx, ny = record->table.ny](const Record& held) {
        return held->table.nx <= nx && held->table.ny <= ny;
    };
    records_.insert(key, std::move(record), bytes, is_covered);
}

}  // namespace contactd::server

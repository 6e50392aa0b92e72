#include "ic_cache.hpp"

#include <algorithm>

#include "store_keeper.hpp"

namespace contactd::server {

IcCache::Record IcCache::find(const std::string& key, int nx, int ny) {
    const std::scoped_lock lock(mutex_);
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
        return e.key == key && e.record->table.nx >= nx && e.record->table.ny >= ny;
    });
    if (entry == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, entry);
    return entry->record;
}

void IcCache::insert(const std::string& key, Record record) {
    const std::size_t bytes = bytes_of(*record);
    if (bytes > budget_) return;
    const std::scoped_lock lock(mutex_);
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const IcTable& held = entry->record->table;
        const bool covered = entry->key == key && held.nx <= record->table.nx && held.ny <= record->table.ny;
        if (covered) bytes_ -= entry->bytes;
        entry = covered ? entries_.erase(entry) : std::next(entry);
    }
    while (bytes_ + bytes > budget_) {
        bytes_ -= entries_.back().bytes;
        entries_.pop_back();
    }
    entries_.push_front({key, std::move(record), bytes});
    bytes_ += bytes;
}

void IcCache::remove(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(entries_, [&](const Entry& entry) {
        if (entry.key != key) return false;
        bytes_ -= entry.bytes;
        return true;
    });
}

IcCache::Usage IcCache::usage() const {
    const std::scoped_lock lock(mutex_);
    return {entries_.size(), bytes_, budget_};
}

}  // namespace contactd::server

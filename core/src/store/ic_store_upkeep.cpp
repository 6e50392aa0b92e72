// What keeps the store's folder in order: sweeping, times of use, eviction.
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <tuple>

#include "contactd/ic_store.hpp"
#include "contactd/table_lock.hpp"
#include "writer.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;

struct AsideFile {
    fs::path path;
    std::uintmax_t bytes = 0;
    fs::file_time_type time;
};

/// Damaged tables that were set aside, the oldest first.
std::vector<AsideFile> set_aside_in(const fs::path& folder) {
    std::vector<AsideFile> files;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder / "quarantine", error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().string().find(".h5.") != std::string::npos && entry->is_regular_file(ignored))
            files.push_back({entry->path(), entry->file_size(ignored), entry->last_write_time(ignored)});
    std::sort(files.begin(), files.end(), [](const AsideFile& a, const AsideFile& b) { return a.time < b.time; });
    return files;
}

bool contains(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Opening a lock and giving it back removes its file; one that is held stays.
bool remove_abandoned_lock(const fs::path& path) {
    TableLock lock(path);
    return lock.try_lock() == TableLock::State::held;
}

}  // namespace

int IcStore::sweep() const {
    int swept = 0;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (path.extension() == ".tmp" && entry->is_regular_file(ignored) && is_abandoned(path))
            swept += fs::remove(path, ignored);
        else if (path.extension() == ".lock" && entry->is_regular_file(ignored))
            swept += remove_abandoned_lock(path);
    }
    return swept;
}

void IcStore::note_use(const fs::path& path) const {
    // The file's own time, so that nothing is rewritten. A clock that was set back must not make what is used now look
    // older than what was used before: times only go forward.
    const auto now = fs::file_time_type::clock::now();
    const std::scoped_lock lock(latest_->mutex);
    latest_->time = std::max(latest_->time + std::chrono::microseconds(1), now);
    std::error_code ignored;
    fs::last_write_time(path, latest_->time, ignored);
}

std::vector<StoredTable> IcStore::evict(std::uintmax_t budget_bytes, const std::vector<std::string>& recent,
                                        const std::vector<std::string>& kept) const {
    std::vector<StoredTable> tables = list();
    const std::vector<AsideFile> aside = set_aside_in(folder_);
    std::uintmax_t bytes = 0;
    for (const AsideFile& file : aside) bytes += file.bytes;
    for (const StoredTable& table : tables) {
        bytes += table.bytes;
        const std::scoped_lock lock(latest_->mutex);
        latest_->time = std::max(latest_->time, table.last_use);
    }
    std::error_code ignored;
    for (const AsideFile& file : aside)
        if (bytes > budget_bytes && fs::remove(file.path, ignored)) bytes -= file.bytes;

    // Not in memory: by time. In memory: after those, the least recent first.
    const auto order = [&](const StoredTable& table) {
        return std::tuple(recent.end() - std::find(recent.begin(), recent.end(), table.key), table.last_use);
    };
    std::sort(tables.begin(), tables.end(),
              [&](const StoredTable& a, const StoredTable& b) { return order(a) < order(b); });
    std::vector<StoredTable> evicted;
    for (const StoredTable& table : tables) {
        if (bytes <= budget_bytes) break;
        if (contains(kept, table.key) || !fs::remove(table.path, ignored)) continue;
        bytes -= table.bytes;
        evicted.push_back(table);
    }
    return evicted;
}

}  // namespace contactd

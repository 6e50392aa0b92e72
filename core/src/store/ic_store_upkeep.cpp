// Maintains the store's folder: sweeping, times of use, eviction.
#include <algorithm>
#include <chrono>
#include <system_error>

#include "contactd/ic_store.hpp"
#include "contactd/table_lock.hpp"
#include "store/hdf5/writer.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;

constexpr auto smallest_step = std::chrono::microseconds(1);  // least difference of two times of use
// A clock that is this much behind the last use was set back.
constexpr auto clock_step = std::chrono::seconds(1);

struct AsideFile {
    fs::path path;
    std::uintmax_t bytes = 0;
    fs::file_time_type time;
};

/// Returns whether a file of the folder may belong to the store, whose file names all begin with a key.
bool begins_with_key(const fs::path& path) {
    const std::string name = path.filename().string();
    return is_ic_key(name.substr(0, name.find('.')));
}

/// Links are not followed, and other things than files are left alone.
bool is_file(const fs::directory_entry& entry) {
    std::error_code gone;
    return fs::is_regular_file(entry.symlink_status(gone));
}

/// Returns the damaged tables that were set aside, the oldest first.
std::vector<AsideFile> set_aside_in(const fs::path& folder) {
    std::vector<AsideFile> files;
    std::error_code error, ignored;
    for (fs::directory_iterator entry(folder / "quarantine", error), end; !error && entry != end;
         entry.increment(error))
        if (begins_with_key(entry->path()) && is_file(*entry))
            files.push_back({entry->path(), entry->file_size(ignored), entry->last_write_time(ignored)});
    std::sort(files.begin(), files.end(), [](const AsideFile& a, const AsideFile& b) { return a.time < b.time; });
    return files;
}

bool contains(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Locking and releasing an unused lock removes its file; the file of a held lock stays.
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
        if (!begins_with_key(path)) continue;  // The folder may contain files of others.
        if (path.extension() == ".tmp" && is_file(*entry) && is_abandoned(path))
            swept += fs::remove(path, ignored);
        else if (path.extension() == ".lock" && is_file(*entry))
            swept += remove_abandoned_lock(path);
    }
    return swept;
}

IcStore::Time IcStore::time_of_use() const {
    const auto now = Time::clock::now();
    const auto later = [&] {
        const std::scoped_lock lock(latest_->mutex);
        if (latest_->time <= now + clock_step) return latest_->time = std::max(latest_->time + smallest_step, now);
        return Time::max();
    };
    if (const Time time = later(); time != Time::max()) return time;
    settle_times();
    const std::scoped_lock lock(latest_->mutex);
    return latest_->time = now + smallest_step;
}

void IcStore::note_use(const fs::path& path, Time used) const {
    // The time of use is that of the file, so that nothing is rewritten, and all users of the folder see it.
    std::error_code error;
    const Time known = fs::last_write_time(path, error);
    if (!error && (known < used || known > Time::clock::now())) fs::last_write_time(path, used, error);
}

void IcStore::settle_times() const {
    std::vector<StoredTable> tables;
    try {
        tables = list();
    } catch (const StoreError&) {
        return;  // Nothing that can be read has a time.
    }
    const auto now = Time::clock::now();  // It is after listing, so that uses by others meanwhile lie in the past.
    std::erase_if(tables, [&](const StoredTable& table) { return table.last_use <= now; });
    std::sort(tables.begin(), tables.end(),
              [](const StoredTable& a, const StoredTable& b) { return a.last_use < b.last_use; });
    std::error_code ignored;
    Time time = now - smallest_step * static_cast<std::ptrdiff_t>(tables.size());
    for (const StoredTable& table : tables) fs::last_write_time(table.path, time += smallest_step, ignored);
}

std::vector<StoredTable> IcStore::evict(std::uintmax_t budget_bytes, const std::vector<std::string>& kept) const {
    settle_times();
    std::vector<StoredTable> tables = list();
    const std::vector<AsideFile> aside = set_aside_in(folder_);
    std::uintmax_t bytes = 0;
    for (const AsideFile& file : aside) bytes += file.bytes;
    for (const StoredTable& table : tables) bytes += table.bytes;
    std::error_code ignored;
    for (const AsideFile& file : aside)
        if (bytes > budget_bytes && fs::remove(file.path, ignored)) bytes -= file.bytes;

    std::sort(tables.begin(), tables.end(),
              [](const StoredTable& a, const StoredTable& b) { return a.last_use < b.last_use; });
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

// Records uses of tables that do not access the disk, because the table is in memory.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>

#include "contactd/ic_store.hpp"

namespace contactd::engine {

/// Writes them into the files' times within a second, so that other daemons with this store, and this one after a
/// restart, can determine the last use, without making requests wait for the disk. Thread-safe.
class UseNotes {
   public:
    explicit UseNotes(const IcStore& store);
    /// Writes the remaining uses.
    ~UseNotes();

    /// Records that the file at `path` is used now.
    void note(const std::filesystem::path& path);
    /// Writes the uses recorded so far.
    void write();

   private:
    void run(const std::stop_token& stop);

    const IcStore& store_;
    std::mutex mutex_;
    std::condition_variable_any noted_;
    std::map<std::filesystem::path, IcStore::Time> uses_;
    std::jthread thread_;  // is destroyed first, because it uses everything above
};

}  // namespace contactd::engine

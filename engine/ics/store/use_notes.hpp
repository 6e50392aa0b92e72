// Uses of tables that never touch the disk, because the table is in memory.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>

#include "contactd/ic_store.hpp"

namespace contactd::engine {

/// Writes them into the files' times within a second, so that other daemons on the store, and this one after a restart,
/// know what was used last, while no request waits for the disk. Thread-safe.
class UseNotes {
   public:
    explicit UseNotes(const IcStore& store);
    /// Writes what is left.
    ~UseNotes();

    /// The file at `path` is used now.
    void note(const std::filesystem::path& path);
    /// Writes what was noted so far.
    void write();

   private:
    void run(const std::stop_token& stop);

    const IcStore& store_;
    std::mutex mutex_;
    std::condition_variable_any noted_;
    std::map<std::filesystem::path, IcStore::Time> uses_;
    std::jthread thread_;  // last: it uses everything above
};

}  // namespace contactd::engine

// Wraps the store for the daemon: disk errors cause a warning, but never the loss of an answer.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"
#include "engine/operation/engine_log.hpp"
#include "use_notes.hpp"

namespace contactd::engine {

/// Thread-safe.
class ResilientStore {
   public:
    using Record = std::shared_ptr<const IcRecord>;
    struct Budgets {
        std::uintmax_t disk_bytes = 0;  ///< limit of all files; 0: no limit
        std::size_t unsaved_bytes = 0;  ///< limit of tables that wait for the disk
    };

    /// Removes left-over files of dead processes, updates times of use, and checks whether the folder is writable.
    ResilientStore(IcStore store, const Budgets& budgets, EngineLog log);

    const IcStore& store() const { return store_; }
    /// These call IcStore::find and may_have, and return nothing if the folder cannot be read.
    std::optional<IcRecord> find(const IcSpec& spec, const TableOwner& owner = {});
    bool may_have(const IcSpec& spec, const TableOwner& owner);
    /// Marks the file of a table served from memory as used now.
    void note_use(const std::string& key, const IcRecord& record, const TableOwner& owner = {});
    /// Removes tables that a newly written table covers, and tables that no longer fit the budget; see IcStore::evict.
    void note_stored(const IcSpec& spec, const std::vector<std::string>& kept, const TableOwner& owner = {});
    /// Returns a table that could not be written with a warning, and keeps it until the folder can be used again.
    Record keep_unsaved(IcRecord record, const std::string& why);
    /// Writes waiting tables if the folder can be used again, and returns them. Usually does nothing.
    std::vector<Record> recover();
    /// Removes the tables of a key, on disk or waiting for it, and returns their number.
    int remove(const std::string& key, const TableOwner& owner);
    /// Returns the reason why the folder cannot be used, as a sentence; empty if it can.
    std::string problem() const;

   private:
    void set_problem(const std::string& sentence);
    bool save(const IcRecord& record);

    const IcStore store_;
    const Budgets budgets_;
    const EngineLog log_;
    UseNotes uses_{store_};
    mutable std::mutex mutex_;
    std::string problem_;
    std::atomic<bool> has_problem_ = false;
    std::chrono::steady_clock::time_point next_attempt_{};
    std::list<Record> unsaved_;  // the oldest first
    std::size_t unsaved_bytes_ = 0;
};

}  // namespace contactd::engine

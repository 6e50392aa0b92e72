// The store as the daemon uses it: what goes wrong with the disk costs a warning and never an answer.
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
        std::uintmax_t disk_bytes = 0;  ///< of all files; 0: no limit
        std::size_t unsaved_bytes = 0;  ///< of tables that wait for the disk
    };

    /// Sweeps what dead processes left, settles times of use, and looks whether the folder can be written to.
    ResilientStore(IcStore store, const Budgets& budgets, EngineLog log);

    const IcStore& store() const { return store_; }
    /// These do what IcStore::find and may_have do; nothing when the folder cannot be read.
    std::optional<IcRecord> find(const IcSpec& spec, const TableOwner& owner = {});
    bool may_have(const IcSpec& spec, const TableOwner& owner);
    /// A table was served from memory: its file counts as used now.
    void note_use(const std::string& key, const IcRecord& record, const TableOwner& owner = {});
    /// A table has just been written: what it covers goes, and what no longer fits the budget; see IcStore::evict.
    void note_stored(const IcSpec& spec, const std::vector<std::string>& kept, const TableOwner& owner = {});
    /// A table could not be written; returns it as it is to be answered, with a warning. It is written when the folder
    /// can be used again.
    Record keep_unsaved(IcRecord record, const std::string& why);
    /// When the folder could not be used and can again: writes what waits for that. Returns what was written. Does
    /// nothing most of the time.
    std::vector<Record> recover();
    /// Removes the tables of a key, on disk or waiting for it; returns how many.
    int remove(const std::string& key, const TableOwner& owner);
    /// Returns why the folder cannot be used, as a sentence; empty when all is well.
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

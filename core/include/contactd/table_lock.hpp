// Ensures one build of a table among all processes that share a store, on one or several machines.
#pragma once

#include <filesystem>
#include <optional>

#include "contactd/platform.hpp"

namespace contactd {

/// Holds an advisory lock on a file next to the tables, which the kernel releases when its holder ends. If locks or
/// files are unavailable, it reports this, and the build continues without: two writers only duplicate work.
class TableLock {
   public:
    enum class State { held, busy, unavailable };
    using Sign = std::filesystem::file_time_type;

    explicit TableLock(std::filesystem::path path) : path_(std::move(path)) {}
    /// Releases the lock and removes its file.
    ~TableLock();
    TableLock(const TableLock&) = delete;
    TableLock& operator=(const TableLock&) = delete;

    State try_lock();
    /// Renews the sign of life. The holder must call this every few seconds, so that others do not wait for a stopped
    /// holder or a failed machine.
    void give_sign() const;
    /// Returns the last sign of life of the holder. Only its changes are meaningful, because clocks may differ.
    std::optional<Sign> sign() const;

   private:
    const std::filesystem::path path_;
    std::optional<platform::OpenFile> file_;
};

}  // namespace contactd

// One build of a table among all processes that share a store, on one machine or several.
#pragma once

#include <filesystem>
#include <optional>

#include "contactd/platform.hpp"

namespace contactd {

/// An advisory lock on a file beside the tables; the kernel gives it back when its holder dies. Where locks or
/// files cannot be had it says so, and the build goes on without: two writers do no harm but work.
class TableLock {
   public:
    enum class State { held, busy, unavailable };
    using Sign = std::filesystem::file_time_type;

    explicit TableLock(std::filesystem::path path) : path_(std::move(path)) {}
    /// Gives the lock back and removes its file.
    ~TableLock();
    TableLock(const TableLock&) = delete;
    TableLock& operator=(const TableLock&) = delete;

    State try_lock();
    /// The holder's sign of life, to be given every few seconds: a stopped holder, or one on a machine that is gone,
    /// must not be waited for.
    void give_sign() const;
    /// The last sign of whoever holds the lock; only whether it changes means something, clocks being what they are.
    std::optional<Sign> sign() const;

   private:
    const std::filesystem::path path_;
    std::optional<platform::OpenFile> file_;
};

}  // namespace contactd

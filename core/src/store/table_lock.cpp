#include "contactd/table_lock.hpp"

#include <system_error>

namespace contactd {

using platform::OpenFile;

TableLock::~TableLock() {
    if (!file_) return;
    std::error_code ignored;
    // The file is removed while locked, so that no other process holds a removed file.
    std::filesystem::remove(path_, ignored);
}

TableLock::State TableLock::try_lock() {
    constexpr int tries = 16;
    for (int n = 0; n < tries; ++n) {
        OpenFile file(path_, OpenFile::Use::locking);
        if (!file.is_open() || !file.is_regular()) return State::unavailable;  // It may be a FIFO, for example.
        const OpenFile::Lock lock = file.try_lock();
        if (lock != OpenFile::Lock::held) return lock == OpenFile::Lock::busy ? State::busy : State::unavailable;
        // The file may have been removed or replaced before it was locked.
        if (file.is_at(path_)) {
            file_ = std::move(file);
            return State::held;
        }
    }
    return State::busy;
}

void TableLock::give_sign() const {
    if (file_) file_->note_change();
}

std::optional<TableLock::Sign> TableLock::sign() const {
    std::error_code error;
    const Sign time = std::filesystem::last_write_time(path_, error);
    return error ? std::nullopt : std::optional<Sign>(time);
}

}  // namespace contactd

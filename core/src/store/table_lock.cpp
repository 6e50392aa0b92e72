#include "contactd/table_lock.hpp"

#include <system_error>

namespace contactd {

using platform::OpenFile;

TableLock::~TableLock() {
    if (!file_) return;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);  // while it is locked, so that nobody else holds what is removed
}

TableLock::State TableLock::try_lock() {
    constexpr int tries = 16;
    for (int n = 0; n < tries; ++n) {
        OpenFile file(path_, OpenFile::Use::locking);
        if (!file.is_open() || !file.is_regular()) return State::unavailable;  // somebody may have put a FIFO there
        const OpenFile::Lock lock = file.try_lock();
        if (lock != OpenFile::Lock::held) return lock == OpenFile::Lock::busy ? State::busy : State::unavailable;
        // It may have been removed, or another may have taken its name, before it was locked.
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

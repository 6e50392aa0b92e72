// Keeps the lines of a log until they are fetched.
#pragma once

#include <deque>
#include <mutex>
#include <string>
#include <utility>

namespace contactd::python {

/// Holds the last lines that have not been fetched. Thread-safe.
class Lines {
   public:
    using Line = std::pair<int, std::string>;  ///< level of Python's logging, and the sentence

    void put(int level, const std::string& sentence) {
        const std::scoped_lock lock(mutex_);
        if (lines_.size() >= kept) lines_.pop_front();
        lines_.emplace_back(level, sentence);
    }
    std::deque<Line> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(lines_, {});
    }

   private:
    static constexpr std::size_t kept = 1000;
    std::mutex mutex_;
    std::deque<Line> lines_;
};

}  // namespace contactd::python

#include "use_notes.hpp"

#include <chrono>
#include <utility>

namespace contactd::engine {
namespace {

constexpr auto interval = std::chrono::seconds(1);

}  // namespace

UseNotes::UseNotes(const IcStore& store) : store_(store), thread_([this](const std::stop_token& stop) { run(stop); }) {}

UseNotes::~UseNotes() {
    thread_.request_stop();
    thread_.join();
    write();
}

void UseNotes::note(const std::filesystem::path& path) {
    const IcStore::Time now = store_.time_of_use();
    bool is_first = false;
    {
        const std::scoped_lock lock(mutex_);
        is_first = uses_.empty();
        uses_[path] = now;
    }
    if (is_first) noted_.notify_one();
}

void UseNotes::write() {
    std::map<std::filesystem::path, IcStore::Time> uses;
    {
        const std::scoped_lock lock(mutex_);
        uses.swap(uses_);
    }
    for (const auto& [path, time] : uses) store_.note_use(path, time);
}

void UseNotes::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::unique_lock lock(mutex_);
        if (!noted_.wait(lock, stop, [this] { return !uses_.empty(); })) return;
        noted_.wait_for(lock, stop, interval, [] { return false; });  // Many uses of a table are written once.
        lock.unlock();
        write();
    }
}

}  // namespace contactd::engine

#include "worker_pool.hpp"

#include <algorithm>
#include <utility>

namespace contactd::server {

WorkerPool::WorkerPool(int threads) {
    for (int n = 0; n < threads; ++n) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
    stop();
}

void WorkerPool::post(Turn turn, Task task) {
    {
        const std::scoped_lock lock(mutex_);
        if (stopping_) return;
        auto& lines = levels_[static_cast<std::size_t>(turn.priority)].lines;
        auto line = std::find_if(lines.begin(), lines.end(), [&](const Line& l) { return l.client == turn.client; });
        if (line == lines.end()) line = lines.insert(lines.end(), Line{std::move(turn.client), {}});
        line->tasks.push_back({std::move(task), std::move(turn.abandoned)});
        ++waiting_;
    }
    changed_.notify_one();
}

void WorkerPool::drop_abandoned() {
    std::vector<Waiting> dropped;  // destroyed after the lock: what they hold may be much
    const std::scoped_lock lock(mutex_);
    for (Level& level : levels_) {
        for (Line& line : level.lines) {
            const auto kept = std::stable_partition(line.tasks.begin(), line.tasks.end(), [](const Waiting& waiting) {
                return !waiting.abandoned || !waiting.abandoned();
            });
            std::move(kept, line.tasks.end(), std::back_inserter(dropped));
            line.tasks.erase(kept, line.tasks.end());
        }
        std::erase_if(level.lines, [](const Line& line) { return line.tasks.empty(); });
    }
    waiting_ -= static_cast<int>(dropped.size());
}

void WorkerPool::stop() {
    Levels dropped;
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
        waiting_ = 0;
        dropped = std::exchange(levels_, {});
    }
    changed_.notify_all();
    threads_.clear();  // joins
}

int WorkerPool::waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_;
}

int WorkerPool::running() const {
    const std::scoped_lock lock(mutex_);
    return running_;
}

WorkerPool::Level& WorkerPool::next_level() {
    const auto has_tasks = [](const Level& level) { return !level.lines.empty(); };
    // Of several that have waited long enough the lowest first: it has waited longest.
    const auto overdue = std::find_if(levels_.rbegin(), levels_.rend(), [&](const Level& level) {
        return has_tasks(level) && level.passed_over >= patience;
    });
    Level& next = overdue != levels_.rend() ? *overdue : *std::find_if(levels_.begin(), levels_.end(), has_tasks);
    next.passed_over = 0;
    for (Level* lower = &next + 1; lower != levels_.data() + levels_.size(); ++lower)
        lower->passed_over = has_tasks(*lower) ? lower->passed_over + 1 : 0;
    return next;
}

WorkerPool::Task WorkerPool::take_next() {
    auto& lines = next_level().lines;
    Line line = std::move(lines.front());
    lines.pop_front();
    Task task = std::move(line.tasks.front().task);
    line.tasks.pop_front();
    if (!line.tasks.empty()) lines.push_back(std::move(line));  // behind everybody else
    --waiting_;
    return task;
}

void WorkerPool::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stopping_ || waiting_ > 0; });
        if (stopping_) return;
        Task task = take_next();
        ++running_;
        lock.unlock();
        task();
        task = nullptr;  // what it holds goes before the thread counts as idle
        lock.lock();
        --running_;
    }
}

}  // namespace contactd::server

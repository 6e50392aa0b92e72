#include "worker_pool.hpp"

#include <algorithm>
#include <utility>

namespace contactd::engine {

WorkerPool::WorkerPool(int threads, std::chrono::microseconds spin)
    : most_(static_cast<std::size_t>(threads)), most_large_(std::max(1, threads - 1)), spin_(spin) {
    threads_.reserve(most_);
}

WorkerPool::~WorkerPool() {
    stop();
}

void WorkerPool::post(QueueTicket ticket, Task task) {
    {
        const std::scoped_lock lock(mutex_);
        if (stopping_) return;
        auto& users = levels_[static_cast<std::size_t>(ticket.priority)].users;
        auto& client = line_of(line_of(users, std::move(ticket.user)).parts, std::move(ticket.client));
        client.parts.push_back({std::move(task), std::move(ticket.abandoned), ticket.is_large});
        ++waiting_;
        const std::size_t needed = static_cast<std::size_t>(running_ + waiting_);
        if (threads_.size() < std::min(needed, most_)) threads_.emplace_back([this] { work(); });
    }
    changed_.notify_one();
}

void WorkerPool::drop_abandoned() {
    std::vector<Waiting> dropped;  // are destroyed after the lock is released, because they may hold much memory
    const std::scoped_lock lock(mutex_);
    const auto is_empty = [](const auto& line) { return line.parts.empty(); };
    const auto is_active = [](const Waiting& waiting) { return !waiting.abandoned || !waiting.abandoned(); };
    for (Level& level : levels_) {
        for (User& user : level.users) {
            for (auto& [name, tasks] : user.parts) {
                const auto abandoned = std::stable_partition(tasks.begin(), tasks.end(), is_active);
                std::move(abandoned, tasks.end(), std::back_inserter(dropped));
                tasks.erase(abandoned, tasks.end());
            }
            std::erase_if(user.parts, is_empty);
        }
        std::erase_if(level.users, is_empty);
    }
    waiting_ -= static_cast<int>(dropped.size());
}

void WorkerPool::each_when_idle(Task task) {
    {
        const std::scoped_lock lock(mutex_);
        idle_task_ = std::move(task);
        ++idle_tasks_;
    }
    changed_.notify_all();
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

bool WorkerPool::may_begin(const User& user) const {
    return std::ranges::any_of(user.parts, [this](const Client& client) { return may_begin(client); });
}

bool WorkerPool::may_begin(const Level& level) const {
    return std::ranges::any_of(level.users, [this](const User& user) { return may_begin(user); });
}

bool WorkerPool::any_may_begin() const {
    return std::ranges::any_of(levels_, [this](const Level& level) { return may_begin(level); });
}

WorkerPool::Level& WorkerPool::next_level() {
    const auto has_tasks = [this](const Level& level) { return may_begin(level); };
    // The lowest of several priorities that have waited long enough goes first, because it has waited longest.
    const auto overdue = std::find_if(levels_.rbegin(), levels_.rend(), [&](const Level& level) {
        return has_tasks(level) && level.passed_over >= most_passes;
    });
    Level& next = overdue != levels_.rend() ? *overdue : *std::find_if(levels_.begin(), levels_.end(), has_tasks);
    next.passed_over = 0;
    for (Level* lower = &next + 1; lower != levels_.data() + levels_.size(); ++lower)
        lower->passed_over = has_tasks(*lower) ? lower->passed_over + 1 : 0;
    return next;
}

/// Returns the line of that name, or adds a new one at the end.
template <class Part>
WorkerPool::Line<Part>& WorkerPool::line_of(std::deque<Line<Part>>& lines, std::string name) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.name == name; });
    return found != lines.end() ? *found : lines.emplace_back(Line<Part>{std::move(name), {}});
}

/// Returns a task from the first line that has one ready to begin, and moves this line to the end.
template <class Part, class Take>
WorkerPool::Waiting WorkerPool::take_round_robin(std::deque<Line<Part>>& lines, const Take& take) const {
    const auto next = std::ranges::find_if(lines, [this](const Line<Part>& line) { return may_begin(line); });
    Line<Part> line = std::move(*next);
    lines.erase(next);
    Waiting task = take(line.parts);
    if (!line.parts.empty()) lines.push_back(std::move(line));
    return task;
}

WorkerPool::Waiting WorkerPool::take_next() {
    const auto first = [](std::deque<Waiting>& tasks) {
        Waiting task = std::move(tasks.front());
        tasks.pop_front();
        return task;
    };
    Waiting task = take_round_robin(next_level().users,
                                    [&](std::deque<Client>& clients) { return take_round_robin(clients, first); });
    --waiting_;
    return task;
}

void WorkerPool::spin() const {
    const auto end = std::chrono::steady_clock::now() + spin_;
    while (waiting_ == 0 && !stopping_ && std::chrono::steady_clock::now() < end) std::this_thread::yield();
}

void WorkerPool::work() {
    std::unique_lock lock(mutex_);
    std::size_t idle_tasks = idle_tasks_;
    for (;;) {
        changed_.wait(lock, [&] { return stopping_ || any_may_begin() || idle_tasks != idle_tasks_; });
        if (stopping_) return;
        if (!any_may_begin()) {
            idle_tasks = idle_tasks_;
            const Task task = idle_task_;
            lock.unlock();
            task();
            lock.lock();
            continue;
        }
        Waiting next = take_next();
        const bool is_large = next.is_large;
        ++running_;
        running_large_ += is_large;
        lock.unlock();
        next.task();
        next = {};  // Must be freed before the thread counts as idle.
        lock.lock();
        --running_;
        running_large_ -= is_large;
        if (is_large && waiting_ > 0) changed_.notify_one();  // Another large task may begin now.
        if (spin_.count() == 0 || waiting_ > 0) continue;
        lock.unlock();
        spin();
        lock.lock();
    }
}

}  // namespace contactd::engine

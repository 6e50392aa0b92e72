#include "worker_pool.hpp"

#include <utility>

namespace contactd::server {

WorkerPool::WorkerPool(int threads) {
    for (int n = 0; n < threads; ++n) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
    stop();
}

void WorkerPool::post(Task task) {
    {
        const std::scoped_lock lock(mutex_);
        if (stopping_) return;
        tasks_.push_back(std::move(task));
    }
    changed_.notify_one();
}

void WorkerPool::stop() {
    std::deque<Task> dropped;
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
        dropped.swap(tasks_);
    }
    changed_.notify_all();
    threads_.clear();  // joins
}

int WorkerPool::waiting() const {
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(tasks_.size());
}

int WorkerPool::running() const {
    const std::scoped_lock lock(mutex_);
    return running_;
}

void WorkerPool::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stopping_ || !tasks_.empty(); });
        if (stopping_) return;
        Task task = std::move(tasks_.front());
        tasks_.pop_front();
        ++running_;
        lock.unlock();
        task();
        task = nullptr;  // what it holds goes before the thread counts as idle
        lock.lock();
        --running_;
    }
}

}  // namespace contactd::server

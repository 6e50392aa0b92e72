#include "helping_threads.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>

#include "handle_guard.hpp"

namespace contactd::c {

struct HelpingThreads::Work {
    std::size_t count, places;  // places are for helpers that may still come
    const std::function<void(std::size_t)>& act;
    std::atomic<std::size_t> next = 0;
    std::size_t helpers = 0;  // at work

    void do_it() {
        for (std::size_t i = next++; i < count; i = next++) act(i);
    }
};

HelpingThreads::~HelpingThreads() {
    leave_to_parent();
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    called_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

// A fork copies the records of threads and their work, but not the threads.
void HelpingThreads::leave_to_parent() {
    if (generation_ == generation()) return;
    for (std::thread& thread : threads_) thread.detach();
    threads_.clear();
    works_.clear();
    generation_ = generation();
}

void HelpingThreads::make(std::size_t count) {
    leave_to_parent();
    try {
        while (threads_.size() < count) threads_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {  // no more threads are available
    }
}

void HelpingThreads::share(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& act) {
    const std::size_t helpers = std::max(std::min(threads, count), std::size_t{1}) - 1;
    Work work{.count = count, .places = helpers, .act = act};
    if (helpers == 0) return work.do_it();
    std::list<Work*>::iterator at;
    {
        const std::lock_guard lock(mutex_);
        make(helpers);
        at = works_.insert(works_.end(), &work);
    }
    if (helpers == 1)
        called_.notify_one();
    else
        called_.notify_all();
    work.do_it();
    std::unique_lock lock(mutex_);
    works_.erase(at);
    left_.wait(lock, [&] { return work.helpers == 0; });
}

void HelpingThreads::help() {
    std::unique_lock lock(mutex_);
    for (;;) {
        std::list<Work*>::iterator at;
        called_.wait(lock, [&] {
            at = std::ranges::find_if(works_, [](const Work* work) { return work->places > 0; });
            return ends_ || at != works_.end();
        });
        if (ends_) return;
        Work& work = **at;
        --work.places;
        ++work.helpers;
        lock.unlock();
        work.do_it();
        lock.lock();
        if (--work.helpers == 0) left_.notify_all();
    }
}

}  // namespace contactd::c

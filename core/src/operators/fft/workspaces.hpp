// Holds work arrays of calls, reused from one to the next.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace contactd {

/// Calls may come from several threads at once: each takes an idle workspace, or creates one, and returns it.
template <class Workspace>
class Workspaces {
   public:
    class Lease {
       public:
        Lease(Workspaces& owner, std::unique_ptr<Workspace> taken) : owner_(owner), taken_(std::move(taken)) {}
        ~Lease() {
            const std::scoped_lock lock(owner_.mutex_);
            owner_.idle_.push_back(std::move(taken_));
        }
        Lease(const Lease&) = delete;
        Lease& operator=(const Lease&) = delete;
        Workspace& operator*() const { return *taken_; }

       private:
        Workspaces& owner_;
        std::unique_ptr<Workspace> taken_;
    };

    template <class Make>
    Lease take(const Make& make) {
        {
            const std::scoped_lock lock(mutex_);
            if (!idle_.empty()) {
                auto last = std::move(idle_.back());
                idle_.pop_back();
                return {*this, std::move(last)};
            }
        }
        return {*this, make()};
    }

   private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace contactd

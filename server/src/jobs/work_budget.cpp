#include "work_budget.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace contactd::server {
namespace {

/// Work of at most this part of the budget waits for memory only.
constexpr double small_part = 1.0 / 64;

struct Waiting {
    CallPtr call;
    double bytes;
    std::function<void()> work;
    bool one_at_a_time;
};

}  // namespace

struct WorkBudget::State : std::enable_shared_from_this<State> {
    explicit State(double limit_) : limit(limit_) {}

    const double limit;
    std::mutex mutex;  // guards the members below
    WorkerPool* workers = nullptr;
    double work = 0, counted = 0;  // Counts bytes of running work, and bytes that are used in any case.
    double so_far = 0;             // bytes given back
    std::multiset<std::string> busy_clients;
    std::deque<Waiting> waiting;

    bool fits(double bytes) const { return work == 0 || work + counted + bytes <= limit; }

    /// Returns the waiting work that may begin now. Its calls hold the bytes.
    std::vector<Waiting> take_ready() {
        std::vector<Waiting> ready;
        bool is_blocked = false;
        for (auto at = waiting.begin(); at != waiting.end();) {
            const bool waits_for_own = at->one_at_a_time && busy_clients.contains(at->call->client());
            const bool may_pass = !is_blocked || at->bytes <= small_part * limit;
            if (waits_for_own || !may_pass || !fits(at->bytes)) {
                is_blocked = is_blocked || !waits_for_own;
                ++at;
                continue;
            }
            hold(*at);
            ready.push_back(std::move(*at));
            at = waiting.erase(at);
        }
        return ready;
    }

    void hold(const Waiting& next) {
        work += next.bytes;
        const std::string client = next.one_at_a_time ? next.call->client() : std::string();
        if (!client.empty()) busy_clients.insert(client);
        next.call->work =
            std::shared_ptr<const void>(nullptr, [state = shared_from_this(), bytes = next.bytes, client](const void*) {
                state->give_back(bytes, 0, client);
            });
    }

    void give_back(double of_work, double of_counted, const std::string& client) {
        std::unique_lock lock(mutex);
        work -= of_work;  // uses whole numbers below 2^53, whose sums return to exactly zero
        counted -= of_counted;
        so_far += of_work + of_counted;
        if (const auto at = busy_clients.find(client); at != busy_clients.end()) busy_clients.erase(at);
        if (waiting.empty() || workers == nullptr) return;
        std::vector<Waiting> ready = take_ready();
        WorkerPool& pool = *workers;
        lock.unlock();
        for (Waiting& next : ready) {
            QueueTicket ticket = ticket_of(next.call);
            pool.post(std::move(ticket), std::move(next.work));
        }
    }
};

WorkBudget::WorkBudget(std::size_t bytes, WorkerPool& workers)
    : state_(std::make_shared<State>(static_cast<double>(bytes))) {
    state_->workers = &workers;
}

WorkBudget::~WorkBudget() {
    close();
}

void WorkBudget::close() {
    std::deque<Waiting> dropped;  // Calls are released without the lock.
    const std::scoped_lock lock(state_->mutex);
    state_->workers = nullptr;
    dropped.swap(state_->waiting);
}

void WorkBudget::enter(const CallPtr& call, double bytes, std::function<void()> work, bool one_at_a_time) {
    call->work.reset();  // not under the lock
    std::vector<Waiting> ready;
    {
        const std::scoped_lock lock(state_->mutex);
        state_->waiting.push_back({call, std::floor(bytes), std::move(work), one_at_a_time});
        ready = state_->take_ready();
    }
    // No memory has been released for other waiting work, so at most this work is ready.
    for (const Waiting& next : ready) next.work();
}

std::shared_ptr<const void> WorkBudget::count(double bytes) {
    const std::scoped_lock lock(state_->mutex);
    state_->counted += std::floor(bytes);
    return {nullptr, [state = state_, bytes = std::floor(bytes)](const void*) { state->give_back(0, bytes, ""); }};
}

void WorkBudget::drop_abandoned() {
    std::vector<Waiting> dropped;  // Calls are released without the lock.
    const std::scoped_lock lock(state_->mutex);
    std::deque<Waiting>& waiting = state_->waiting;
    const auto unwanted = std::stable_partition(waiting.begin(), waiting.end(),
                                                [](const Waiting& next) { return !next.call->answered(); });
    std::move(unwanted, waiting.end(), std::back_inserter(dropped));
    waiting.erase(unwanted, waiting.end());
}

std::size_t WorkBudget::bytes() const {
    const std::scoped_lock lock(state_->mutex);
    return static_cast<std::size_t>(state_->work + state_->counted);
}

WorkBudget::Use WorkBudget::use() const {
    const std::scoped_lock lock(state_->mutex);
    return {state_->work, state_->so_far};
}

std::size_t WorkBudget::waiting() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->waiting.size();
}

}  // namespace contactd::server

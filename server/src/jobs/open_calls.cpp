#include "open_calls.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace contactd::server {
namespace {

constexpr int queue_retry_ms = 500;

[[noreturn]] void refuse(const std::string& what, std::size_t limit, const char* name,
                         std::string_view reason = proto::reason::queue_full) {
    throw proto::StatusError(proto::Status{proto::StatusCode::resource_exhausted,
                                           what + " are waiting for an answer, and at most " + std::to_string(limit) +
                                               " are allowed (" + name + "). Try again later.",
                                           std::string(reason),
                                           {},
                                           queue_retry_ms});
}

}  // namespace

void OpenCalls::check(const Route& route, std::size_t bytes) const {
    if (entries_.size() >= bounds_.calls)
        refuse(std::to_string(entries_.size()) + " requests", bounds_.calls, "limits.max_queue");
    const auto own = per_client_.find(route.identity);
    if (own != per_client_.end() && own->second >= bounds_.calls_per_client)
        refuse(std::to_string(own->second) + " requests of this client", bounds_.calls_per_client,
               "limits.max_queue_per_client");
    const auto users = per_user_.find(route.user);
    if (bounds_.calls_per_user > 0 && users != per_user_.end() && users->second >= bounds_.calls_per_user)
        refuse(std::to_string(users->second) + " requests of yours", bounds_.calls_per_user,
               "security.per_user.open_requests", proto::reason::too_many_open);
    const std::size_t open_bytes = bytes_;
    if (open_bytes > 0 && open_bytes + bytes > bounds_.bytes)
        refuse("Requests of " + std::to_string(open_bytes) + " bytes and this one of " + std::to_string(bytes),
               bounds_.bytes, "limits.max_queue_bytes");
}

OpenCalls::Admission OpenCalls::admit(const Route& route, std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    check(route, bytes);
    const Number number = ++last_;
    entries_.emplace(number, Entry{route, nullptr});
    ++per_client_[route.identity];
    ++per_user_[route.user];
    bytes_ += bytes;
    return {number, ReservedBytes(nullptr, [this, bytes](const void*) { bytes_ -= bytes; })};
}

bool OpenCalls::attach(Number number, const CallPtr& call) {
    const std::scoped_lock lock(mutex_);
    const auto at = entries_.find(number);
    if (at == entries_.end()) return false;
    at->second.call = call;
    if (call->deadline() != Call::Clock::time_point::max()) deadlines_.emplace(call->deadline(), number);
    return true;
}

void OpenCalls::forget(const Entry& entry, Number number) {
    if (entry.call) deadlines_.erase({entry.call->deadline(), number});
    const auto own = per_client_.find(entry.route.identity);
    if (--own->second == 0) per_client_.erase(own);
    const auto users = per_user_.find(entry.route.user);
    if (--users->second == 0) per_user_.erase(users);
}

void OpenCalls::close(Number number) {
    CallPtr last;  // may be destroyed here, outside the lock
    const std::scoped_lock lock(mutex_);
    const auto at = entries_.find(number);
    if (at == entries_.end()) return;
    forget(at->second, number);
    last = std::move(at->second.call);
    entries_.erase(at);
}

bool OpenCalls::has_unread(const std::string& client) const {
    const std::scoped_lock lock(mutex_);
    return per_client_.contains(client) && std::any_of(entries_.begin(), entries_.end(), [&](const auto& numbered) {
               return !numbered.second.call && numbered.second.route.identity == client;
           });
}

std::vector<CallPtr> OpenCalls::find(const std::string& client, const std::string& id) const {
    std::vector<CallPtr> found;
    const std::scoped_lock lock(mutex_);
    if (!per_client_.contains(client)) return found;
    for (const auto& [number, entry] : entries_)
        if (entry.call && entry.route.identity == client && entry.call->request.id == id && !entry.call->answered())
            found.push_back(entry.call);
    return found;
}

std::vector<CallPtr> OpenCalls::overdue(Call::Clock::time_point now) const {
    std::vector<CallPtr> found;
    const std::scoped_lock lock(mutex_);
    for (const auto& [deadline, number] : deadlines_) {
        if (deadline > now) break;
        found.push_back(entries_.at(number).call);
    }
    return found;
}

Call::Clock::time_point OpenCalls::next_deadline() const {
    const std::scoped_lock lock(mutex_);
    for (const auto& [deadline, number] : deadlines_)
        if (!entries_.at(number).call->answered()) return deadline;
    return Call::Clock::time_point::max();
}

std::vector<std::pair<OpenCalls::Number, OpenCalls::Entry>> OpenCalls::of(const std::string& client) const {
    std::vector<std::pair<Number, Entry>> found;
    const std::scoped_lock lock(mutex_);
    if (!per_client_.contains(client)) return found;
    std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(found),
                 [&](const auto& numbered) { return numbered.second.route.identity == client; });
    return found;
}

std::vector<OpenCalls::Entry> OpenCalls::take_all() {
    std::vector<Entry> taken;
    const std::scoped_lock lock(mutex_);
    for (auto& [number, entry] : entries_) taken.push_back(std::move(entry));
    entries_.clear();
    per_client_.clear();
    per_user_.clear();
    deadlines_.clear();
    return taken;
}

std::vector<OpenCalls::Entry> OpenCalls::all() const {
    std::vector<Entry> found;
    const std::scoped_lock lock(mutex_);
    for (const auto& [number, entry] : entries_) found.push_back(entry);
    return found;
}

std::size_t OpenCalls::count() const {
    const std::scoped_lock lock(mutex_);
    return entries_.size();
}

}  // namespace contactd::server

// The methods of the daemon: what each is called, how it is run, and what it does.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "contactd/proto/message.hpp"
#include "daemon_parts.hpp"
#include "jobs/work_budget.hpp"

namespace contactd::server {

struct Method {
    std::string_view name;                               ///< as on the wire
    bool is_quick = false;                               ///< runs in the I/O thread, all others in a worker
    bool takes_turn = false;                             ///< in the session it names, in the order of arrival
    bool counts = !is_quick;                             ///< among the requests that wait for an answer
    proto::Priority priority = proto::Priority::normal;  ///< of requests that name none
    const char* job = nullptr;                           ///< what job.list calls it, where it is listed
    /// Whether the work of a call is so small that the I/O thread may do it when no other request is open: waking a
    /// worker would take as long.
    bool (*is_small)(const CallPtr& call, const DaemonParts& parts) = nullptr;
    /// What the work will take in memory and time, of params that have passed their schema; null where it is little.
    /// What exceeds limits.* is refused, and work waits until its memory is free. With `queue` the method asks itself.
    WorkCost (*cost)(const nlohmann::json& params, const Config& config) = nullptr;
    /// Of a method whose work is that of several turns: hands it on from the I/O thread, in place of `handle`.
    void (*queue)(const CallPtr& call, const DaemonParts& parts) = nullptr;
    /// Answers the call now or later, or throws what becomes the answer. The parameters have passed their schema.
    void (*handle)(const CallPtr& call, const DaemonParts& parts) = nullptr;
};

class MethodTable {
   public:
    void add(const Method& method) { methods_.emplace(method.name, method); }
    /// Null when there is no such method.
    const Method* find(std::string_view name) const;
    std::vector<std::string> names() const;

   private:
    std::map<std::string_view, Method> methods_;
};

}  // namespace contactd::server

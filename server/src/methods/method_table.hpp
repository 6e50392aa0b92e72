// Describes the methods of the daemon: their names, threads and handlers.
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
    bool is_immediate = false;                           ///< runs in the I/O thread, all others in a worker
    bool in_session_order = false;                       ///< runs in the session that it names, in the order of arrival
    bool counts = !is_immediate;                         ///< counts among the requests that wait for an answer
    proto::Priority priority = proto::Priority::normal;  ///< default for requests without a priority
    const char* job = nullptr;                           ///< kind in job.list, if it is listed
    /// Returns whether the work of a call is so small that the I/O thread may do it if no other request is open,
    /// because waking a worker would take as long.
    bool (*is_small)(const CallPtr& call, const DaemonParts& parts) = nullptr;
    /// Returns the cost of the work in memory and time, from params that have been checked against their schema; null
    /// if it is small. Costs beyond limits.* are refused, and work waits until its memory is free. With `queue` the
    /// method checks the cost itself.
    WorkCost (*cost)(const nlohmann::json& params, const Config& config) = nullptr;
    /// Queues the parts of methods with several parts in the I/O thread, instead of `handle`.
    void (*queue)(const CallPtr& call, const DaemonParts& parts) = nullptr;
    /// Answers the call now or later, or throws an exception that becomes the answer. The parameters have been checked
    /// against their schema.
    void (*handle)(const CallPtr& call, const DaemonParts& parts) = nullptr;
};

class MethodTable {
   public:
    void add(const Method& method) { methods_.emplace(method.name, method); }
    /// Returns the method, or null if it does not exist.
    const Method* find(std::string_view name) const;
    std::vector<std::string> names() const;

   private:
    std::map<std::string_view, Method> methods_;
};

}  // namespace contactd::server

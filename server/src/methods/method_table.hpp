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
    bool is_immediate = false;                           ///< runs in the I/O thread, all others in a worker
    bool in_session_order = false;                       ///< runs in the session that it names, in the order of arrival
    bool counts = !is_immediate;                         ///< among the requests that wait for an answer
    proto::Priority priority = proto::Priority::normal;  ///< of requests that name none
    const char* job = nullptr;                           ///< what job.list calls it, where it is listed
    /// Whether the work of a call is so small that the I/O thread may do it when no other request is open: waking a
    /// worker would take as long.
    bool (*is_small)(const CallPtr& call, const DaemonParts& parts) = nullptr;
    /// The cost of the work in memory and time, from params that have passed their schema; null where it is little.
    /// Costs beyond limits.* are refused, and work waits until its memory is free. With `queue` the method asks itself.
    WorkCost (*cost)(const nlohmann::json& params, const Config& config) = nullptr;
    /// For a method whose work comes in several parts: hands them on from the I/O thread, in place of `handle`.
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

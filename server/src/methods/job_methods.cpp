// Implements job.* and request.cancel: waiting and running work, and its cancellation.
#include <chrono>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "all_methods.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::StatusCode;
using proto::StatusError;

namespace {

/// Returns each user once, without unnamed ones.
std::set<std::string> named(const std::vector<std::string>& users) {
    std::set<std::string> names(users.begin(), users.end());
    names.erase("");
    return names;
}

void list_jobs(const CallPtr& call, const DaemonParts& parts) {
    json jobs = json::array();
    for (const auto& job : parts.jobs.all()) {
        const engine::JobProgress progress = job->progress();
        const std::vector<std::string> callers = job->users();
        json entry = {{"job", job->name},
                      {"kind", job->kind},
                      {"state", job->running() ? "running" : "queued"},
                      {"stage", progress.stage},
                      {"fraction", progress.fraction},
                      {"callers", callers.size()},
                      {"users", named(callers)},
                      {"description", job->description},
                      {"seconds", std::chrono::duration<double>(Call::Clock::now() - job->created).count()}};
        if (progress.seconds_left) entry["seconds_left"] = *progress.seconds_left;
        if (progress.memory_bytes) entry["memory_bytes"] = *progress.memory_bytes;
        jobs.push_back(std::move(entry));
    }
    call->succeed({{"jobs", std::move(jobs)}});
}

void cancel_job(const CallPtr& call, const DaemonParts& parts) {
    const std::string name = call->request.params.at("job");
    const auto job = parts.jobs.find(name);
    if (!job)
        throw StatusError(StatusCode::not_found, proto::reason::job_unknown,
                          "There is no job " + json(name).dump() + "; call job.list for waiting and running jobs.");
    job->cancel();
    parts.drop_abandoned();
    call->succeed({{"job", name}});
}

void cancel_request(const CallPtr& call, const DaemonParts& parts) {
    const std::string id = call->request.params.at("id");
    const auto open = parts.open_calls.find(call->client(), id);
    if (open.empty())
        throw StatusError(StatusCode::not_found, proto::reason::request_unknown,
                          "No request of this client with the id " + json(id).dump() + " waits for an answer.");
    for (const CallPtr& cancelled : open)
        cancelled->fail({StatusCode::cancelled,
                         "The request was cancelled by its client.",
                         std::string(proto::reason::request_cancelled),
                         {},
                         0});
    parts.drop_abandoned();
    call->succeed({{"id", id}});
}

}  // namespace

void add_job_methods(MethodTable& methods) {
    methods.add({.name = "job.list", .is_immediate = true, .handle = list_jobs});
    methods.add({.name = "job.cancel", .is_immediate = true, .handle = cancel_job});
    methods.add({.name = "request.cancel", .is_immediate = true, .handle = cancel_request});
}

}  // namespace contactd::server

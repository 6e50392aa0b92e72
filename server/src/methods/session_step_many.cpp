#include "handlers.hpp"

#include <atomic>
#include <utility>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/session.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"
#include "shared_check.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

struct StepBatch;
void check_limits(const StepBatch& batch);

/// Represents several steps of one call.
struct StepBatch {
    CallPtr call;
    const DaemonParts& parts;
    std::vector<SessionPtr> sessions;  // null for steps without a session
    std::vector<proto::ResultOrStatus> results{sessions.size()};
    SharedCheck check{call, [this] { check_limits(*this); }};
    std::atomic<std::size_t> finished = 0;

    const json& params(std::size_t index) const { return call->request.params["steps"][index]; }
};
using StepBatchPtr = std::shared_ptr<StepBatch>;

void check_limits(const StepBatch& batch) {
    const proto::Request& request = batch.call->request;
    proto::check_frames_used(request.params, request.frames);
    std::vector<ArrayAnswer> answers;
    for (std::size_t i = 0; i < batch.sessions.size(); ++i)
        if (batch.sessions[i])
            answers.push_back({proto::decode_fields(batch.params(i), {}), batch.sessions[i]->elements()});
    check_answer_fits(answers, request.arrays, batch.parts.config.limits);
    WorkCost cost;
    for (const SessionPtr& session : batch.sessions) cost.seconds += session ? session->step_seconds : 0;
    check_cost(cost, batch.parts.config);
}

void answer(StepBatch& batch) {
    guarded(batch.call, [&] {
        proto::Frames frames;
        const std::string result = proto::encode_results("steps", std::move(batch.results), frames);
        batch.call->succeed_with(result, std::move(frames));
    });
}

proto::ResultOrStatus solved(StepBatch& batch, std::size_t index) {
    const std::shared_ptr<Job> job = batch.parts.jobs.create(origin_of(*batch.call, "step"), [] {});
    proto::ResultOrStatus result;
    const auto send = [&](const StepAnswer& answer) {
        result = proto::Result{answer.text, answer.frames};
        return !batch.call->answered();
    };
    try {
        if (!batch.sessions[index]) throw session_unknown();
        batch.sessions[index]->step({batch.params(index),
                                     batch.call,
                                     job,
                                     [&](const JobProgress& p) { job->set_progress(p); },
                                     {},
                                     send,
                                     batch.parts.recent_solves},
                                    batch.parts.engine);
    } catch (const std::exception& error) {
        result = status_of(error);
    }
    job->end();
    return result;
}

void take(const StepBatchPtr& batch, std::size_t index) {
    batch->call->check_deadline();
    if (batch->call->answered()) return;
    if (!batch->check.passed()) return;
    batch->results[index] = solved(*batch, index);
    if (++batch->finished == batch->sessions.size()) answer(*batch);
}

}  // namespace

void queue_steps(const CallPtr& call, const DaemonParts& parts) {
    // The schema is checked when the first step runs. Only members that determine the next session are checked here.
    const auto steps = call->request.params.find("steps");
    std::vector<SessionPtr> sessions(1);
    if (steps != call->request.params.end() && steps->is_array() && !steps->empty()) {
        sessions.clear();
        for (const json& step : *steps) {
            const bool named = step.is_object() && step.contains("session") && step["session"].is_string();
            sessions.push_back(named ? parts.sessions.find_open(step["session"].get_ref<const std::string&>())
                                     : nullptr);
        }
    }
    parts.counters.solves += static_cast<long long>(sessions.size());
    const auto batch = StepBatchPtr(new StepBatch{call, parts, std::move(sessions)});
    for (std::size_t i = 0; i < batch->sessions.size(); ++i) {
        auto work = [batch, i] { take(batch, i); };
        QueueTicket ticket = ticket_of(call);
        const SessionPtr& session = batch->sessions[i];
        ticket.is_large = session && is_large(session->step_seconds);
        if (session)
            session->enqueue(std::move(ticket), std::move(work), parts.workers);
        else
            parts.workers.post(std::move(ticket), std::move(work));
    }
}

}  // namespace contactd::server

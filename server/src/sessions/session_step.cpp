// The steps of a session.
#include <functional>
#include <utility>

#include "jobs/job_reports.hpp"
#include "session.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;
using proto::StatusCode;
using proto::StatusError;

namespace {

/// Tells one request from another with the same number.
std::size_t hash_of(const proto::Request& request) {
    const std::hash<std::string> hash;
    std::size_t value = hash(proto::dump(request.params));
    for (const std::string& frame : request.frames) value = value * 31 + hash(frame);
    return value;
}

StatusError out_of_order(long long is, long long last) {
    std::string problem = "is " + std::to_string(is) + "; it must be " + std::to_string(last + 1) + ", the next one";
    if (last > 0) problem += ", or " + std::to_string(last) + " to hear the last answer again";
    return StatusError(Status{StatusCode::failed_precondition,
                              "step " + problem + ".",
                              std::string(proto::reason::step_out_of_order),
                              {{"step", problem}},
                              0});
}

StatusError differs(long long step) {
    const std::string problem = "is " + std::to_string(step) +
                                ", which was answered to another request; the next one is " + std::to_string(step + 1) +
                                ", and session.restore goes back";
    return StatusError(Status{StatusCode::failed_precondition,
                              "step " + problem + ".",
                              std::string(proto::reason::step_differs),
                              {{"step", problem}},
                              0});
}

}  // namespace

void Session::step(const CallPtr& call, engine::Engine& engine) {
    if (call->answered()) return;
    std::shared_ptr<Job> job;
    Status status;
    try {
        const SessionStatePtr before = state();
        const auto number = call->request.params["step"].get<long long>();
        if (number == before->contact.step) return replay(*before, call);
        if (number != before->contact.step + 1) throw out_of_order(number, before->contact.step);
        call->outlive_client();  // who reconnects asks for the step again, and finds it done
        job = job_of(call, "step", engine.jobs());
        {
            const std::scoped_lock lock(mutex_);
            if (closed_) throw session_unknown();
            job_ = job;
        }
        job->set_running();
        solve_step(*before, call, job, engine);
    } catch (const std::exception& error) {
        status = status_of(error);
    }
    if (job) job->end();
    {
        const std::scoped_lock lock(mutex_);
        job_.reset();
    }
    if (!status.ok()) call->fail(status);
}

void Session::replay(const SessionState& state, const CallPtr& call) const {
    if (closed()) throw session_unknown();
    if (hash_of(call->request) != state.answer.request) throw differs(state.contact.step);
    call->succeed(state.answer.result, state.answer.frames);
}

void Session::solve_step(const SessionState& before, const CallPtr& call, const std::shared_ptr<Job>& job,
                         engine::Engine& engine) {
    const proto::Request& request = call->request;
    const auto statement = [&](const std::optional<Motion>& last, ContactProblem& problem) {
        proto::apply_step(request.params, request.frames, last, problem);
        proto::check_frames_used(request.params, request.frames);
    };
    Reporter reporter(call, job);
    JobObserver observer(call, job, [&](const Progress& progress) { reporter.report(to_job_progress(progress)); });
    observer.throw_if_cancelled();
    ContactSolution solution = engine.solve(*steps_, before.contact, statement, observer);

    auto after = std::make_shared<SessionState>();
    proto::ArrayWriter arrays(request.arrays);
    after->answer.request = hash_of(request);
    after->answer.result = proto::encode_step_reply(before.contact.step + 1, solution, opened().grid,
                                                    proto::decode_fields(request.params), arrays);
    after->answer.frames = arrays.take_frames();
    after->contact = engine::ContactSteps::after(before.contact, std::move(solution));
    job->end();
    // First, since whoever has the answer may ask at once how far the session is.
    const SessionStatePtr last = state();
    set_state(after);
    if (!call->succeed(after->answer.result, after->answer.frames)) set_state(last);
}

}  // namespace contactd::server

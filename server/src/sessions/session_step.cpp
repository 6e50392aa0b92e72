// The steps of a session.
#include <functional>
#include <utility>

#include "contactd/proto/codec.hpp"
#include "session.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;
using proto::StatusCode;
using proto::StatusError;

namespace {

/// Distinguishes requests with the same number; in a message with several steps only the arrays of this step count.
std::size_t hash_of(const json& params, const proto::Frames& frames) {
    const std::hash<std::string_view> hash;
    std::size_t value = std::hash<json>()(params);
    const std::vector<bool> used = proto::frames_used(params, frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (used[i]) value = value * 31 + hash(frames[i].bytes());
    return value;
}

StatusError out_of_order(long long is, long long last) {
    std::string problem = "is " + std::to_string(is) + "; it must be " + std::to_string(last + 1) + ", the next one";
    if (last > 0) problem += ", or " + std::to_string(last) + " to repeat the last answer";
    return StatusError(Status{StatusCode::failed_precondition,
                              "step " + problem + ".",
                              std::string(proto::reason::step_out_of_order),
                              {{"step", problem}},
                              0});
}

StatusError differs(long long step) {
    const std::string problem = "is " + std::to_string(step) +
                                ", but another request was already answered for this step; the next step is " +
                                std::to_string(step + 1) + ". Set again to solve this step anew";
    return StatusError(Status{StatusCode::failed_precondition,
                              "step " + problem + ".",
                              std::string(proto::reason::step_differs),
                              {{"step", problem}},
                              0});
}

}  // namespace

void Session::begin(const std::shared_ptr<Job>& job) {
    const std::scoped_lock lock(mutex_);
    if (closed_) throw session_unknown();
    job_ = job;
}

void Session::step(const StepRequest& request, engine::Engine& engine) {
    begin(request.job);
    // The job no longer belongs to the session in any case.
    const std::shared_ptr<void> end(nullptr, [this](void*) {
        const std::scoped_lock lock(mutex_);
        job_.reset();
    });
    const SessionStatePtr here = state();
    const long long last = here->last->step, number = request.params["step"].get<long long>();
    const std::size_t hash = hash_of(request.params, request.call->request.frames);
    if (number == last + 1) return solve_step(here->last, hash, request, engine);
    if (number != last || !here->before) throw out_of_order(number, last);
    if (hash == here->answer.request)
        request.send(here->answer);
    else if (request.params.value("again", false))
        solve_step(here->before, hash, request, engine);
    else
        throw differs(last);
}

void Session::solve_step(const std::shared_ptr<const engine::StepState>& before, std::size_t hash,
                         const StepRequest& request, engine::Engine& engine) {
    const proto::Request& message = request.call->request;
    JobObserver observer(request.call, request.job,
                         [&](const Progress& progress) { request.report(to_job_progress(progress)); });
    request.call->outlive_client();  // After a reconnection, a client requests the step again and gets its result.
    request.job->set_running();
    observer.throw_if_cancelled();
    proto::ArrayWriter arrays(message.arrays);
    Simulation::Solved solved = simulation_->solve(*before, request, arrays, observer, engine);

    auto after = std::make_shared<SessionState>();
    after->answer = {hash, std::make_shared<const std::string>(std::move(solved.text)), arrays.take_frames()};
    after->last = std::make_shared<const engine::StepState>(std::move(solved.after));
    after->before = before;
    // Comes first, because a client may query the session as soon as it has the answer.
    const SessionStatePtr last = state();
    set_state(after);
    if (!request.send(after->answer)) set_state(last);
}

}  // namespace contactd::server

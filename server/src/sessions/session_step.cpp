// The steps of a session.
#include <functional>
#include <utility>

#include "contactd/solve_contact.hpp"
#include "ics/problem_tables.hpp"
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

/// Names the solvers that missed their tolerance.
StatusError not_converged(const ContactSolution& solution) {
    std::string solvers;
    const auto add = [&](const char* name, const std::optional<SolverEvidence>& evidence) {
        if (!evidence || evidence->converged) return;
        solvers += (solvers.empty() ? "" : ", ") + std::string(name) + " after " +
                   std::to_string(evidence->iterations) + " iterations at the residual " +
                   proto::dump(evidence->residual);
    };
    add("normal", solution.evidence.normal);
    add("tangential", solution.evidence.tangential);
    add("outer", solution.evidence.outer);
    add("force", solution.evidence.force);
    return {StatusCode::aborted, proto::reason::not_converged,
            "The step did not converge (" + solvers +
                "), and the session stays where it was: take a smaller step, or open the session with other settings "
                "or with accept_unconverged."};
}

}  // namespace

void Session::step(const CallPtr& call, const SolveTools& tools) {
    if (call->answered()) return;
    std::shared_ptr<Job> job;
    Status status;
    try {
        const SessionStatePtr before = state();
        const auto number = call->request.params["step"].get<long long>();
        if (number == before->step) return replay(*before, call);
        if (number != before->step + 1) throw out_of_order(number, before->step);
        call->outlive_client();  // who reconnects asks for the step again, and finds it done
        job = job_of(call, "step", tools.jobs);
        {
            const std::scoped_lock lock(mutex_);
            if (closed_) throw session_unknown();
            job_ = job;
        }
        job->set_running();
        solve_step(*before, call, job, tools);
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
    if (hash_of(call->request) != state.answer.request) throw differs(state.step);
    call->succeed(state.answer.result, state.answer.frames);
}

void Session::solve_step(const SessionState& before, const CallPtr& call, const std::shared_ptr<Job>& job,
                         const SolveTools& tools) {
    state_problem(before, call->request);
    fit_influence(tools.influences);
    Reporter reporter(call, job);
    JobObserver observer(call, job, [&](const Progress& progress) { reporter.report(to_job_progress(progress)); });
    observer.throw_if_cancelled();
    ContactSolution solution = solve_contact(problem_, influence_, observer);
    count(tools.counters, solution);
    if (!solution.converged() && !accept_unconverged) throw not_converged(solution);

    auto after = std::make_shared<SessionState>();
    after->step = before.step + 1;
    proto::ArrayWriter arrays(call->request.arrays);
    after->answer.request = hash_of(call->request);
    after->answer.result = proto::encode_step_reply(after->step, solution, problem_.grid,
                                                    proto::decode_fields(call->request.params), arrays);
    after->answer.frames = arrays.take_frames();
    after->motion = solution.motion;
    after->tractions = {std::move(solution.pressure), std::move(solution.traction_x), std::move(solution.traction_y)};
    job->end();
    // First, since whoever has the answer may ask at once how far the session is.
    const SessionStatePtr last = state();
    set_state(after);
    if (!call->succeed(after->answer.result, after->answer.frames)) set_state(last);
}

void Session::state_problem(const SessionState& before, const proto::Request& request) {
    problem_.friction = opened.friction;
    problem_.gap = opened.gap;
    problem_.approach = opened.approach;
    problem_.Fn = opened.Fn;
    problem_.motion = opened.motion;
    problem_.rigid_slip = opened.rigid_slip;
    proto::apply_step(request.params, request.frames, before.motion, problem_);
    proto::check_frames_used(request.params, request.frames);
    if (problem_.model != Model::full) return;  // the quick ones know no history and need no estimate
    problem_.previous = before.tractions;
    problem_.initial = before.tractions;
}

void Session::fit_influence(InfluenceCache& cache) {
    const auto wanted = step_of(problem_);
    if (problem_.model != Model::full || wanted == std::array<double, 2>{} || wanted == rolling_step_) return;
    validate(problem_);
    influence_ = influence_of(problem_, ics_, cache);
    rolling_step_ = wanted;
}

}  // namespace contactd::server

#include "solve_task.hpp"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "engine/ics/problem_tables.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {
namespace {

using engine::IcAnswers;

/// Holds a task and the tables of its bodies.
struct Solve {
    SolveTask task;
    engine::Engine& engine;
    RecentSolves& recent;
    IcAnswers ics;
};
using SolvePtr = std::shared_ptr<Solve>;

void solve(const SolvePtr& work) {
    const SolveTask& task = work->task;
    try {
        JobObserver observer(task.call, task.job, task.progress);
        observer.throw_if_cancelled();
        task.job->set_running();
        const auto begun = RecentSolves::Clock::now();
        const SolveReply reply = work->engine.solve(task.problem, work->ics, observer);
        work->recent.add(*task.call, begun, reply.solution, task.problem.grid);
        task.done(reply);
    } catch (const std::exception& error) {
        task.failed(status_of(error));
    }
}

}  // namespace

void start(const SolveTools& tools, SolveTask task) {
    const auto work = std::make_shared<Solve>(Solve{std::move(task), tools.engine, tools.recent, {}});
    // If the tables are available, the worker continues itself, because another one would have to wake up first.
    const auto caller = work->task.in_caller ? std::this_thread::get_id() : std::thread::id();
    const auto queue = [work, caller, &workers = tools.workers] {
        if (std::this_thread::get_id() == caller) return solve(work);
        workers.post(ticket_of(work->task.call), [work] { solve(work); });
    };
    if (!engine::needs_tables(work->task.problem)) return queue();
    const auto specs = engine::specs_of(work->task.problem);
    const bool may_wait = work->task.bytes > 0 && std::ranges::any_of(specs, [](const std::optional<IcSpec>& spec) {
                              return spec && spec->source == IcSource::fem;
                          });
    if (may_wait) work->task.call->work.reset();  // a build may take hours
    engine::fetch_pair(tools.engine.tables(), specs,
                       {[work, queue, may_wait, &budget = tools.budget](const IcAnswers& answers) {
                            work->ics = answers;
                            if (!may_wait) return queue();
                            budget.enter(work->task.call, work->task.bytes, queue);
                        },
                        work->task.failed, reports_to(work->task.call), ticket_of(work->task.call)});
}

}  // namespace contactd::server

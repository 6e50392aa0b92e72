#include "solve_task.hpp"

#include <thread>
#include <utility>

#include "contactd/solve_contact.hpp"
#include "ics/problem_tables.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {
namespace {

/// A task and the tables of its bodies.
struct Solve {
    SolveTask task;
    InfluenceCache& influences;
    Counters& counters;
    IcAnswers ics;
};
using SolvePtr = std::shared_ptr<Solve>;

void solve(const SolvePtr& work) {
    const SolveTask& task = work->task;
    try {
        JobObserver observer(task.call, task.job, task.progress);
        observer.throw_if_cancelled();
        task.job->set_running();
        SolveReply reply;
        reply.solution = solve_contact(task.problem, influence_of(task.problem, work->ics, work->influences), observer);
        count(work->counters, reply.solution);
        reply.ics = uses_of(task.problem, work->ics);
        task.done(reply);
    } catch (const std::exception& error) {
        task.failed(status_of(error));
    }
}

}  // namespace

void count(Counters& counters, const ContactSolution& solution) {
    ++(solution.converged() ? counters.solves_converged : counters.solves_not_converged);
    counters.normal_iterations += solution.evidence.normal.iterations;
    if (solution.evidence.tangential) counters.tangential_iterations += solution.evidence.tangential->iterations;
}

void start(const SolveTools& tools, SolveTask task) {
    const auto work = std::make_shared<Solve>(Solve{std::move(task), tools.influences, tools.counters, {}});
    // A worker that finds the tables at hand goes on by itself: another one would have to wake up first.
    const auto caller = work->task.in_caller ? std::this_thread::get_id() : std::thread::id();
    const auto queue = [work, caller, &workers = tools.workers] {
        if (std::this_thread::get_id() == caller) return solve(work);
        workers.post(turn_of(work->task.call), [work] { solve(work); });
    };
    if (!needs_tables(work->task.problem)) return queue();
    fetch_pair(
        work->task.call, tools.ics, specs_of(work->task.problem),
        [work, queue](const IcAnswers& answers) {
            work->ics = answers;
            queue();
        },
        work->task.failed);
}

}  // namespace contactd::server

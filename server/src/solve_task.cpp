#include "solve_task.hpp"

#include <thread>
#include <utility>

#include "contactd/ic_exchange.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/tangential.hpp"
#include "contactd/version.hpp"
#include "ic_pair.hpp"
#include "job_reports.hpp"

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

IcSpec spec_of(const ContactProblem& problem, const Material& material) {
    const Grid& grid = problem.grid;
    return {problem.ics, material, grid.dx, grid.dy, grid.nx, grid.ny};
}

bool needs_tables(const ContactProblem& problem) {
    return problem.model == Model::full && !problem.given_ics;
}

IcTable body_table(const Solve& work, std::size_t body, const Material& material) {
    const Grid& grid = work.task.problem.grid;
    if (material.is_rigid()) return IcTable(grid.nx, grid.ny);
    return table_of(work.ics[body], spec_of(work.task.problem, material));
}

ContactInfluence influence_of(const Solve& work) {
    const ContactProblem& problem = work.task.problem;
    if (problem.model != Model::full) return {};
    if (problem.given_ics) return make_influence(problem, problem.given_ics->table);
    return work.influences.of(influence_key(problem, work.ics[0].key, work.ics[1].key), [&] {
        return make_influence(
            problem, pair_of(body_table(work, 0, problem.bodies.upper), body_table(work, 1, problem.bodies.lower)));
    });
}

void add_ics(const Solve& work, proto::SolveReply& reply) {
    const ContactProblem& problem = work.task.problem;
    if (problem.model != Model::full) return;
    if (problem.given_ics) {
        reply.pair = {"given", ic_key(*problem.given_ics), {}};
        reply.pair->evidence.source = "table";
        reply.pair->evidence.version = "contactd " + version();
        return;
    }
    const auto use = [&](std::size_t body) {
        const IcAnswer& answer = work.ics[body];
        return proto::IcUse{answer.origin, answer.key, answer.record->evidence};
    };
    if (!problem.bodies.upper.is_rigid()) reply.upper = use(0);
    if (!problem.bodies.lower.is_rigid()) reply.lower = use(1);
}

void solve(const SolvePtr& work) {
    const SolveTask& task = work->task;
    try {
        JobObserver observer(task.call, task.job, task.progress);
        observer.throw_if_cancelled();
        task.job->set_running();
        proto::SolveReply reply;
        reply.solution = solve_contact(task.problem, influence_of(*work), observer);
        count(work->counters, reply.solution);
        add_ics(*work, reply);
        task.done(reply);
    } catch (const std::exception& error) {
        task.failed(status_of(error));
    }
}

/// The tables wanted; none of a rigid body.
std::array<std::optional<IcSpec>, 2> specs_of(const ContactProblem& problem) {
    std::array<std::optional<IcSpec>, 2> specs;
    const auto& [upper, lower] = problem.bodies;
    if (!upper.is_rigid()) specs[0] = spec_of(problem, upper);
    if (!lower.is_rigid()) specs[1] = spec_of(problem, lower);
    return specs;
}

}  // namespace

void count(Counters& counters, const ContactSolution& solution) {
    ++(solution.converged() ? counters.solves_converged : counters.solves_not_converged);
    counters.normal_iterations += solution.normal.iterations;
    if (solution.tangential) counters.tangential_iterations += solution.tangential->iterations;
}

void check(const ContactProblem& problem) {
    validate(problem);
    if (!needs_tables(problem)) return;
    const auto specs = specs_of(problem);
    if (specs[0]) validate_body(*specs[0], "bodies.upper");
    if (specs[1]) validate_body(*specs[1], "bodies.lower");
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

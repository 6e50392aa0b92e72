#include "contact_solve.hpp"

#include <atomic>
#include <utility>

#include "contactd/error.hpp"
#include "ics/problem_tables.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {
namespace {

/// Several problems of one call.
struct Batch {
    CallPtr call;
    SolveTools tools;
    std::shared_ptr<Job> job;
    std::vector<proto::ProblemOrStatus> problems;
    std::vector<Grid> grids;
    std::vector<ReplyOrStatus> replies{problems.size()};
    Reporter reporter{call, job};
    std::atomic<std::size_t> next = 0, finished = 0;

    std::size_t size() const { return problems.size(); }
};
using BatchPtr = std::shared_ptr<Batch>;

void answer(const BatchPtr& batch) {
    batch->job->end();
    if (batch->call->answered()) return;
    guarded(batch->call, [&] {
        proto::ArrayWriter arrays(batch->call->request.arrays);
        const nlohmann::json result = proto::encode_solve_replies(batch->replies, batch->grids, arrays);
        batch->call->succeed(result, arrays.take_frames());
    });
}

void solve_next(const BatchPtr& batch);

void finish(const BatchPtr& batch, std::size_t index, ReplyOrStatus reply) {
    batch->replies[index] = std::move(reply);
    const std::size_t finished = ++batch->finished;
    batch->reporter.report(
        {"batch", static_cast<double>(finished) / static_cast<double>(batch->size()), static_cast<int>(finished), 0});
    if (finished == batch->size()) return answer(batch);
    solve_next(batch);
}

/// Takes problems that cannot be solved as stated off the list, and starts the first one that can.
void solve_next(const BatchPtr& batch) {
    const std::size_t index = batch->next++;
    if (index >= batch->size()) return;
    const auto failed = [batch, index](const proto::Status& status) { finish(batch, index, status); };
    if (const auto* status = std::get_if<proto::Status>(&batch->problems[index])) return failed(*status);
    ContactProblem& problem = std::get<ContactProblem>(batch->problems[index]);
    try {
        if (batch->job->cancelled() || batch->call->answered()) throw Cancelled("The batch was cancelled.");
        check(problem);
        start(batch->tools, {batch->call, std::move(problem), batch->job, [](const Progress&) {},
                             [batch, index](const SolveReply& reply) { finish(batch, index, reply); }, failed});
    } catch (const std::exception& error) {
        failed(status_of(error));
    }
}

}  // namespace

void start_solve(const CallPtr& call, const SolveTools& tools) {
    ContactProblem problem = proto::decode_problem(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);  // after those that are missing
    check(problem);
    const auto job = job_of(call, "solve", tools.jobs);
    const auto reporter = std::make_shared<Reporter>(call, job);
    const Grid grid = problem.grid;
    start(tools, {call, std::move(problem), job,
                  [reporter](const Progress& progress) { reporter->report(to_job_progress(progress)); },
                  [call, job, grid](const SolveReply& reply) {
                      proto::ArrayWriter arrays(call->request.arrays);
                      const nlohmann::json result = proto::encode_solve_reply(reply, grid, arrays);
                      job->end();
                      call->succeed(result, arrays.take_frames());
                  },
                  [call, job](const proto::Status& status) {
                      job->end();
                      call->fail(status);
                  },
                  true});
}

void start_solve_many(const CallPtr& call, const SolveTools& tools, int threads, const MessageLimits& limits) {
    std::vector<proto::ProblemOrStatus> problems =
        proto::decode_problems(call->request.params, call->request.frames, limits);
    proto::check_frames_used(call->request.params, call->request.frames);
    std::vector<Grid> grids;
    for (const auto& problem : problems) {
        const auto* valid = std::get_if<ContactProblem>(&problem);
        grids.push_back(valid ? valid->grid : Grid{});
    }
    const auto job = job_of(call, "solve", tools.jobs);
    const auto batch = BatchPtr(new Batch{call, tools, job, std::move(problems), std::move(grids)});
    for (int thread = 0; thread < threads; ++thread) solve_next(batch);
}

}  // namespace contactd::server

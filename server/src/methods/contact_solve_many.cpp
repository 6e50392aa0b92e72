#include "contact_solve_many.hpp"

#include <atomic>
#include <utility>

#include "contactd/error.hpp"
#include "engine/ics/problem_tables.hpp"
#include "jobs/job_reports.hpp"
#include "request_limits.hpp"

namespace contactd::server {
namespace {

/// Several problems of one call.
struct Batch {
    CallPtr call;
    SolveTools tools;
    std::shared_ptr<Job> job;
    std::vector<proto::ProblemOrStatus> problems;
    std::vector<Grid> grids;
    std::vector<SolutionFields> fields;
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
        const nlohmann::json result = proto::encode_solve_replies(batch->replies, batch->grids, arrays, batch->fields);
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
        engine::check(problem);
        start(batch->tools, {batch->call, std::move(problem), batch->job, [](const Progress&) {},
                             [batch, index](const SolveReply& reply) { finish(batch, index, reply); }, failed});
    } catch (const std::exception& error) {
        failed(status_of(error));
    }
}

}  // namespace

void solve_many(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    const nlohmann::json& stated = request.params.at("problems");
    check_grid_limits(stated, parts.config.max_grid_elements);
    std::vector<ArrayAnswer> answers;
    std::vector<SolutionFields> fields;
    for (const nlohmann::json& problem : stated) {
        answers.push_back(array_answer(problem));
        fields.push_back(proto::decode_fields(problem, all_solution_fields));
    }
    check_answer_fits(answers, request.arrays, parts.config.limits);
    parts.counters.solves += static_cast<long long>(stated.size());
    std::vector<proto::ProblemOrStatus> problems =
        proto::decode_problems(request.params, request.frames, parts.config.limits);
    proto::check_frames_used(request.params, request.frames);
    std::vector<Grid> grids;
    for (const auto& problem : problems) {
        const auto* valid = std::get_if<ContactProblem>(&problem);
        grids.push_back(valid ? valid->grid : Grid{});
    }
    const auto job = job_of(call, "solve", parts.jobs);
    const auto batch =
        BatchPtr(new Batch{call, parts.solve_tools(), job, std::move(problems), std::move(grids), std::move(fields)});
    for (int thread = 0; thread < parts.config.workers; ++thread) solve_next(batch);
}

}  // namespace contactd::server

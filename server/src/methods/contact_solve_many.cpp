#include "handlers.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "contactd/error.hpp"
#include "engine/ics/problem_tables.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"
#include "shared_check.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

/// Number of small problems that a worker solves before it is released.
constexpr int small_at_once = 16;

struct SolveBatch;
void conclude_check(SolveBatch& batch);

/// Represents several problems of one call.
struct SolveBatch : std::enable_shared_from_this<SolveBatch> {
    SolveBatch(CallPtr its_call, const DaemonParts& its_parts) : call(std::move(its_call)), parts(its_parts) {}

    const CallPtr call;
    const DaemonParts& parts;
    std::shared_ptr<Job> job = job_of(call, "solve", parts.jobs);
    Reporter reporter{call, job};
    SharedCheck check{call, [this] { conclude_check(*this); }};
    std::vector<proto::ResultOrStatus> results{};
    std::atomic<bool> admitted = false;  // its memory is counted
    std::atomic<std::thread::id> concluding{};
    std::atomic<std::size_t> next = 0, finished = 0;

    const json& problems() const { return call->request.params["problems"]; }
};
using SolveBatchPtr = std::shared_ptr<SolveBatch>;
void admit(const SolveBatchPtr& batch);

/// Checks all problems together, each of which has passed its schema.
void conclude_check(SolveBatch& batch) {
    const proto::Request& request = batch.call->request;
    const Config& config = batch.parts.config;
    check_grid_limits(batch.problems(), config.max_grid_elements);
    std::vector<ArrayAnswer> answers;
    for (const json& problem : batch.problems()) answers.push_back(array_answer(problem));
    check_answer_fits(answers, request.arrays, config.limits);
    proto::check_referred_elements(batch.problems(), config.limits);
    proto::check_frames_used(request.params, request.frames);
    batch.results.resize(batch.problems().size());
    const WorkCost cost = cost_of_solve_many(request.params, config);
    check_cost(cost, config);
    batch.parts.counters.solves += static_cast<long long>(batch.results.size());
    // A client's batches run one after the other, because alternating batches would all keep results until the last one
    // is finished.
    batch.concluding = std::this_thread::get_id();
    batch.parts.budget.enter(batch.call, cost.bytes, [self = batch.shared_from_this()] { admit(self); }, true);
    batch.concluding = std::thread::id();
}

void take(const SolveBatchPtr& batch);

void post(const SolveBatchPtr& batch) {
    batch->parts.workers.post(ticket_of(batch->call), [batch] { take(batch); });
}

/// Allows each worker to take some of its problems.
void call_all(const SolveBatchPtr& batch) {
    for (int worker = 0; worker < batch->parts.config.workers; ++worker) post(batch);
}

/// Runs now, while workers wait for the end of the check, or later.
void admit(const SolveBatchPtr& batch) {
    batch->admitted = true;
    if (batch->concluding != std::this_thread::get_id()) call_all(batch);
}

void answer(const SolveBatch& batch, std::vector<proto::ResultOrStatus> results) {
    batch.job->end();
    if (batch.call->answered()) return;
    guarded(batch.call, [&] {
        proto::Frames frames;
        const std::string result = proto::encode_results("solutions", std::move(results), frames);
        batch.call->succeed_with(result, std::move(frames));
    });
}

void finish(SolveBatch& batch, std::size_t index, proto::ResultOrStatus result) {
    batch.results[index] = std::move(result);
    const std::size_t all = batch.results.size(), finished = ++batch.finished;
    batch.reporter.report(
        {"batch", static_cast<double>(finished) / static_cast<double>(all), static_cast<int>(finished), 0});
    if (finished == all) answer(batch, std::move(batch.results));
}

/// Returns nothing if the problem is invalid, and stores this as its result.
std::optional<ContactProblem> read(SolveBatch& batch, std::size_t index) {
    try {
        if (batch.job->cancelled() || batch.call->answered()) throw Cancelled("The batch was cancelled.");
        ContactProblem problem = proto::decode_problem(batch.problems()[index], batch.call->request.frames);
        engine::check(problem);
        return problem;
    } catch (const std::exception& error) {
        finish(batch, index, status_of(error));
        return {};
    }
}

/// Returns the task that solves the problem at `index` and then calls `then`.
SolveTask task_of(const SolveBatchPtr& batch, std::size_t index, ContactProblem problem, std::function<void()> then) {
    const Grid grid = problem.grid;
    const auto done = [=](const SolveReply& reply) {
        const SolutionFields fields = proto::decode_fields(batch->problems()[index], all_solution_fields);
        finish(*batch, index, proto::encode_outcome(reply, grid, batch->call->request.arrays, fields));
        then();
    };
    const auto failed = [=](const proto::Status& status) {
        finish(*batch, index, status);
        then();
    };
    return {batch->call, std::move(problem), batch->job, [](const Progress&) {}, done, failed, 0, true};
}

/// Takes the next problems in a worker, as many as may run before other work.
void take(const SolveBatchPtr& batch) {
    batch->call->check_deadline();
    if (batch->call->answered() || !batch->check.passed() || !batch->admitted) return;
    const std::size_t all = batch->problems().size();
    for (int taken = 0; taken < small_at_once; ++taken) {
        const std::size_t index = batch->next++;
        if (index >= all) return;
        std::optional<ContactProblem> problem = read(*batch, index);
        if (!problem) continue;
        const bool is_small = is_small_solve(problem->model, problem->grid.size()) && !engine::needs_tables(*problem);
        const std::function<void()> then = is_small ? [] {} : std::function<void()>([batch] { post(batch); });
        start(batch->parts.solve_tools(), task_of(batch, index, std::move(*problem), then));
        if (!is_small) return;
    }
    post(batch);
}

}  // namespace

void queue_problems(const CallPtr& call, const DaemonParts& parts) {
    call_all(std::make_shared<SolveBatch>(call, parts));
}

}  // namespace contactd::server

#include "contact_solve.hpp"

#include <chrono>
#include <utility>

#include "contactd/convolution.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/observer.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/tangential.hpp"
#include "contactd/version.hpp"
#include "ic_pair.hpp"

namespace contactd::server {
namespace {

using Clock = Call::Clock;

/// Short solves need no progress: the first message comes after this time, and then one in each interval.
constexpr auto progress_interval = std::chrono::milliseconds(200);

/// Hands progress to the job and to the caller; ends the solve when the job is cancelled or nobody waits any more.
class SolveObserver final : public Observer {
   public:
    SolveObserver(const CallPtr& call, Job& job) : call_(call), job_(job) {}

    void on_progress(const Progress& progress) override {
        const auto now = Clock::now();
        if (now - last_ < progress_interval) return;
        last_ = now;
        const JobProgress shown{std::string(progress.stage), progress.fraction, progress.iteration, progress.residual};
        job_.set_progress(shown);
        call_->progress(to_json(job_, shown));
    }
    bool cancelled() const override { return job_.cancelled() || call_->answered(); }

   private:
    const CallPtr& call_;
    Job& job_;
    Clock::time_point last_ = Clock::now();
};

/// A solve on its way: first the tables of both bodies, then the worker.
struct Solve {
    CallPtr call;
    ContactProblem problem;
    std::shared_ptr<Job> job;
    IcAnswers ics;
};
using SolvePtr = std::shared_ptr<Solve>;

IcSpec spec_of(const ContactProblem& problem, const Material& material) {
    const Grid& grid = problem.grid;
    return {problem.ics, material, grid.dx, grid.dy, grid.nx, grid.ny};
}

IcTable pair_table(const Solve& work) {
    const ContactProblem& problem = work.problem;
    if (problem.given_ics) return problem.given_ics->table;
    return pair_of(table_of(work.ics[0], spec_of(problem, problem.bodies.upper)),
                   table_of(work.ics[1], spec_of(problem, problem.bodies.lower)));
}

void solve(const SolvePtr& work) {
    const CallPtr& call = work->call;
    const ContactProblem& problem = work->problem;
    SolveObserver observer(call, *work->job);
    observer.throw_if_cancelled();
    work->job->set_running();
    const ConvolutionOperator influence(pair_table(*work), problem.grid.nx, problem.grid.ny);
    proto::SolveReply reply;
    reply.solution = solve_contact(problem, influence, observer);
    if (problem.given_ics) {
        reply.pair = {"given", ic_key(*problem.given_ics), {}};
        reply.pair->evidence.source = "table";
        reply.pair->evidence.version = "contactd " + version();
    } else {
        reply.upper = {work->ics[0].origin, work->ics[0].key, work->ics[0].record->evidence};
        reply.lower = {work->ics[1].origin, work->ics[1].key, work->ics[1].record->evidence};
    }
    proto::ArrayWriter arrays(call->request.arrays);
    const nlohmann::json result = proto::encode_solve_reply(reply, problem.grid, arrays);
    work->job->end();
    call->succeed(result, arrays.take_frames());
}

void fail(const SolvePtr& work, const proto::Status& status) {
    work->job->end();
    work->call->fail(status);
}

void run_solve(const SolvePtr& work) {
    try {
        solve(work);
    } catch (const std::exception& error) {
        fail(work, status_of(error));
    }
}

proto::StatusError coupled(const std::string& why) {
    return {proto::StatusCode::failed_precondition, proto::reason::bodies_coupled, why};
}

void check_bodies(const ContactProblem& problem) {
    validate_body(spec_of(problem, problem.bodies.upper), "bodies.upper");
    validate_body(spec_of(problem, problem.bodies.lower), "bodies.lower");
    if (problem.friction && !problem.bodies.quasi_identical())
        throw coupled(
            "bodies.lower differs from bodies.upper so that normal and tangential contact influence "
            "each other, (1-2nu)/G being unequal; with friction this is not solved yet. Leave out "
            "friction, or take quasi-identical bodies.");
}

void check_given(const ContactProblem& problem) {
    if (!problem.friction) return;
    const double found = coupling(problem.given_ics->table);
    if (found > coupling_tolerance)
        throw coupled("ics.table couples normal and tangential contact: its largest xz, zx, yz or zy is " +
                      proto::dump(found) + " of zz at the origin, above " + proto::dump(coupling_tolerance) +
                      ", and with friction this is not solved yet. Leave out friction, or set these four components "
                      "to zero if they are nothing but errors.");
}

}  // namespace

void start_solve(const CallPtr& call, IcService& ics, WorkerPool& workers, JobTable& jobs) {
    auto work = std::make_shared<Solve>();
    work->call = call;
    work->problem = proto::decode_problem(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);  // after those that are missing
    const ContactProblem& problem = work->problem;
    validate(problem);
    if (problem.given_ics)
        check_given(problem);
    else
        check_bodies(problem);
    work->job = jobs.create("solve", [call] { call->fail(status_of(Cancelled("The solve was cancelled."))); });
    const auto queue = [work, &workers] { workers.post([work] { run_solve(work); }); };
    if (problem.given_ics) return queue();
    fetch_pair(
        call, ics, {spec_of(problem, problem.bodies.upper), spec_of(problem, problem.bodies.lower)},
        [work, queue](const IcAnswers& answers) {
            work->ics = answers;
            queue();
        },
        [work](const proto::Status& status) { fail(work, status); });
}

}  // namespace contactd::server

// contact.*: problems solved, and stresses under what was solved.
#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <variant>

#include "all_methods.hpp"
#include "contactd/subsurface.hpp"
#include "engine/ics/problem_tables.hpp"
#include "handlers.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/cost_parts.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"

namespace contactd::server {
namespace {

/// Whether the solve is small, from parameters that have not passed their schema yet.
bool is_small(const CallPtr& call, const DaemonParts&) {
    const nlohmann::json& params = call->request.params;
    const auto model = params.find("model"), grid = params.find("grid");
    if (model == params.end() || grid == params.end() || !grid->is_object()) return false;
    std::size_t elements = 1;
    for (const char* side : {"nx", "ny"}) {
        const auto count = grid->find(side);
        if (count == grid->end() || !count->is_number_unsigned() || *count > 10'000) return false;
        elements *= count->get<std::size_t>();
    }
    return is_small_solve(*model == "hertz" || *model == "fastsim" ? Model::hertz : Model::full, elements);
}

void solve(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    check_answer_fits(std::array{array_answer(request.params)}, request.arrays, parts.config.limits);
    ++parts.counters.solves;
    ContactProblem problem = proto::decode_problem(request.params, request.frames);
    proto::check_frames_used(request.params, request.frames);  // after those that are missing
    engine::check(problem);
    const auto job = job_of(call, "solve", parts.jobs);
    const auto reporter = std::make_shared<Reporter>(call, job);
    const Grid grid = problem.grid;
    start(parts.solve_tools(), {call, std::move(problem), job,
                                [reporter](const Progress& progress) { reporter->report(to_job_progress(progress)); },
                                [call, job, grid, fields = proto::decode_fields(request.params, all_solution_fields)](
                                    const SolveReply& reply) {
                                    proto::ArrayWriter arrays(call->request.arrays);
                                    const nlohmann::json result =
                                        proto::encode_solve_reply(reply, grid, arrays, fields);
                                    job->end();
                                    call->succeed(result, arrays.take_frames());
                                },
                                [call, job](const proto::Status& status) {
                                    job->end();
                                    call->fail(status);
                                },
                                cost_of_solve(request.params, parts.config).bytes, true});
}

SubsurfaceReply computed(const SubsurfaceRequest& request, Observer& observer) {
    const SurfaceTractions tractions =
        tractions_on(request.body, request.pressure, request.traction_x, request.traction_y);
    SubsurfaceReply reply;
    reply.stress = std::visit(
        [&](const auto& points) {
            if (request.ics.layered)
                return subsurface_stress(request.grid, tractions, *request.ics.layered, points, observer);
            if (request.ics.line_contact)
                return subsurface_stress(request.grid, tractions, PlaneStrain{request.nu}, points, observer);
            return subsurface_stress(request.grid, tractions, request.nu, points, observer);
        },
        request.points);
    reply.shape = request.shape();
    const auto [x, y, z] = request.point(reply.stress.largest);
    reply.largest = {reply.stress.von_mises[reply.stress.largest], x, y, z};
    return reply;
}

void subsurface(const CallPtr& call, const DaemonParts& parts) {
    const SubsurfaceRequest request =
        proto::decode_subsurface_request(call->request.params, call->request.frames, parts.config.limits);
    proto::check_frames_used(call->request.params, call->request.frames);  // after those that are missing
    const auto job = job_of(call, "subsurface", parts.jobs);
    job->set_running();
    Reporter reporter(call, job);
    JobObserver observer(call, job, [&](const Progress& progress) { reporter.report(to_job_progress(progress)); });
    const SubsurfaceReply reply = computed(request, observer);
    proto::ArrayWriter arrays(call->request.arrays);
    const nlohmann::json result = proto::encode_subsurface_reply(reply, arrays);
    job->end();
    call->succeed(result, arrays.take_frames());
}

}  // namespace

void add_contact_methods(MethodTable& methods) {
    methods.add(
        {.name = "contact.solve", .job = "solve", .is_small = is_small, .cost = cost_of_solve, .handle = solve});
    methods.add({.name = "contact.solve_many",
                 .priority = proto::Priority::low,
                 .job = "solve",
                 .cost = cost_of_solve_many,
                 .queue = queue_problems});
    methods.add({.name = "contact.subsurface", .job = "subsurface", .cost = cost_of_subsurface, .handle = subsurface});
}

}  // namespace contactd::server

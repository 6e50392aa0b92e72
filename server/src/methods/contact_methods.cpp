// Implements contact.*: solves, and stresses below the contact.
#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <variant>

#include "all_methods.hpp"
#include "contactd/subsurface.hpp"
#include "contactd/surface_temperature.hpp"
#include "engine/ics/problem_tables.hpp"
#include "handlers.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/cost_parts.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"

namespace contactd::server {
namespace {

/// Returns whether the solve is small, from parameters that have not been checked against their schema.
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
    return is_small_solve(*model == "full" ? Model::full : Model::hertz, elements);
}

void solve(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    check_answer_fits(std::array{array_answer(request.params)}, request.arrays, parts.config.limits);
    ++parts.counters.solves;
    ContactProblem problem = proto::decode_problem(request.params, request.frames);
    proto::check_frames_used(request.params, request.frames);  // Comes after errors of missing fields.
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
            if (!request.angles.empty())
                return subsurface_stress(request.grid, tractions, request.nu, request.angles, points, observer);
            return subsurface_stress(request.grid, tractions, request.nu, points, observer);
        },
        request.points);
    if (request.invariants) find_invariants(reply.stress);
    if (request.G)
        reply.displacement =
            subsurface_displacement(request.grid, tractions, {*request.G, request.nu}, request.points, observer);
    reply.shape = request.shape();
    const auto [x, y, z] = request.point(reply.stress.largest);
    reply.largest = {reply.stress.von_mises[reply.stress.largest], x, y, z};
    return reply;
}

// Describes the cost of a block: bytes of each point and of each offset of a point from an element, and seconds of each
// corner.
constexpr double bytes_of_stress = 8 * 14, bytes_of_invariants = 8 * 10, bytes_of_displacement = 8 * 6,
                 bytes_of_stress_offset = 8 * 40, seconds_of_corner = 1.5e-7,
                 curved_fields = 2;  // five loads for three

WorkCost cost_of_subsurface(const nlohmann::json& params, const Config& config) {
    check_grid_limit(params, config.max_grid_elements);
    const double elements = elements_of(params.at("grid"));
    double points = 1, offsets = 0, corners = 0;
    if (const nlohmann::json* block = member(params, "block")) {
        std::array<double, 3> along{1, 1, 1};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            along[axis] = length_of(block->at(std::array{"x", "y", "z"}[axis]));
        }
        points = along[0] * along[1] * along[2];
        offsets = (along[0] + params.at("grid").at("nx").get<double>()) *
                  (along[1] + params.at("grid").at("ny").get<double>());
        // Corners of points in rows of whole elements; others are summed up one by one, and look at their deadline.
        corners = 3 * along[2] * std::min(offsets, along[0] * along[1] * elements);
    } else if (const nlohmann::json* list = member(params, "points")) {
        points = length_of(*list);
        corners = points * elements;
    }
    const bool layered = any_body(params, "layered");
    const double per_offset = layered ? 4 * bytes_of_stress_offset : bytes_of_stress_offset;
    return {bytes_beside + elements * 100 +
                points * (bytes_of_stress + (params.value("invariants", false) ? bytes_of_invariants : 0) +
                          (params.contains("G") ? bytes_of_displacement : 0)) +
                std::min(offsets, 16e6) * per_offset,
            corners * (layered ? seconds_of_layered_offset : seconds_of_corner) *
                (params.contains("angles") ? curved_fields : 1)};
}

void subsurface(const CallPtr& call, const DaemonParts& parts) {
    const SubsurfaceRequest request =
        proto::decode_subsurface_request(call->request.params, call->request.frames, parts.config.limits);
    proto::check_frames_used(call->request.params, call->request.frames);  // Comes after errors of missing fields.
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

WorkCost cost_of_temperature(const nlohmann::json& params, const Config& config) {
    constexpr double bytes_of_element = 8 * 12, seconds_of_pair = 1.5e-9;  // from a source to an element behind it
    check_grid_limit(params, config.max_grid_elements);
    const double elements = elements_of(params.at("grid"));
    return {bytes_beside + elements * bytes_of_element,
            elements * (2e-8 + 0.5 * params.at("grid").at("nx").get<double>() * seconds_of_pair)};
}

void temperature(const CallPtr& call, const DaemonParts& parts) {
    const TemperatureRequest request = proto::decode_temperature_request(call->request.params, call->request.frames);
    proto::check_frames_used(call->request.params, call->request.frames);  // Comes after errors of missing fields.
    const auto job = job_of(call, "temperature", parts.jobs);
    job->set_running();
    Reporter reporter(call, job);
    JobObserver observer(call, job, [&](const Progress& progress) { reporter.report(to_job_progress(progress)); });
    const SurfaceTemperatures reply = surface_temperature(request, observer);
    proto::ArrayWriter arrays(call->request.arrays);
    const nlohmann::json result = proto::encode_temperature_reply(reply, request.grid, arrays);
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
    methods.add(
        {.name = "contact.temperature", .job = "temperature", .cost = cost_of_temperature, .handle = temperature});
}

}  // namespace contactd::server

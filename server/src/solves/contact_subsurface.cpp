#include "contact_subsurface.hpp"

#include <variant>

#include "contactd/proto/codec.hpp"
#include "contactd/subsurface.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {
namespace {

SubsurfaceReply computed(const SubsurfaceRequest& request, Observer& observer) {
    const SurfaceTractions tractions =
        tractions_on(request.body, request.pressure, request.traction_x, request.traction_y);
    SubsurfaceReply reply;
    reply.stress = std::visit(
        [&](const auto& points) { return subsurface_stress(request.grid, tractions, request.nu, points, observer); },
        request.points);
    reply.shape = request.shape();
    const auto [x, y, z] = request.point(reply.stress.largest);
    reply.largest = {reply.stress.von_mises[reply.stress.largest], x, y, z};
    return reply;
}

}  // namespace

void answer_subsurface(const CallPtr& call, JobTable& jobs, const MessageLimits& limits) {
    const SubsurfaceRequest request =
        proto::decode_subsurface_request(call->request.params, call->request.frames, limits);
    proto::check_frames_used(call->request.params, call->request.frames);  // after those that are missing
    const auto job = job_of(call, "subsurface", jobs);
    job->set_running();
    Reporter reporter(call, job);
    JobObserver observer(call, job, [&](const Progress& progress) { reporter.report(to_job_progress(progress)); });
    const SubsurfaceReply reply = computed(request, observer);
    proto::ArrayWriter arrays(call->request.arrays);
    const nlohmann::json result = proto::encode_subsurface_reply(reply, arrays);
    job->end();
    call->succeed(result, arrays.take_frames());
}

}  // namespace contactd::server

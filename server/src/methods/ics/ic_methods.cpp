// Implements ic.*: tables of influence coefficients.
#include <utility>

#include "contactd/finite.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/ic_part.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/strip_frames.hpp"
#include "jobs/job_reports.hpp"
#include "methods/all_methods.hpp"
#include "methods/costs/cost_parts.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"
#include "methods/handlers.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;

namespace {

void get_table(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    const IcSpec spec = proto::decode_ic_spec(call->request.params, call->request.frames);
    validate(spec);
    const proto::IcPart part = proto::decode_ic_part(call->request.params, table_rows(spec));
    if (call->request.arrays == proto::ArrayEncoding::frame) proto::check_size(part, spec.nx, parts.config.limits);
    // Reports an invalid section in the lengths of the request before anything is built.
    const std::vector<StripFrame> frames = strip_frames(spec);
    const auto tell = [call, spec, part, frames, threads = parts.config.workers](const engine::IcAnswer& answer) {
        guarded(call, [&] {
            proto::ArrayWriter arrays(call->request.arrays);
            try {
                IcTable table = table_for(*answer.record, spec, threads, CallObserver(call));
                const json result = proto::encode_ic_part_reply(
                    {answer.key, answer.origin, spec, std::move(table), answer.record->evidence, frames}, part, arrays);
                call->succeed(result, arrays.take_frames());
            } catch (const NotFinite&) {
                throw proto::invalid_field("material.G",
                                           "and grid.dx result in coefficients that exceed the range of a double");
            }
        });
    };
    const bool may_wait = spec.source == IcSource::fem;
    if (may_wait) call->work.reset();  // a build may take hours
    const double bytes = cost_of_table(call->request.params, parts.config).bytes;
    const auto done = [call, tell, may_wait, bytes, &budget = parts.budget](const engine::IcAnswer& answer) {
        if (!may_wait) return tell(answer);
        budget.enter(call, bytes, [tell, answer] { tell(answer); });
    };
    parts.ics.request(spec,
                      {done, [call](const Status& status) { call->fail(status); }, reports_to(call), ticket_of(call)});
}

WorkCost cost_of_import(const json& params, const Config&) {
    double numbers = 0;
    for (const auto& [path, array] : params.at("datasets").items()) numbers += numbers_of(array);
    // Counts the arrays, their record, the closed form for comparison, and the file.
    return {bytes_beside + 5 * sizeof(double) * numbers, seconds_of_offset * numbers};
}

}  // namespace

void add_ic_methods(MethodTable& methods) {
    methods.add({.name = "ic.get", .cost = cost_of_table, .handle = get_table});
    methods.add({.name = "ic.export", .cost = cost_of_export, .handle = export_table});
    methods.add({.name = "ic.import", .cost = cost_of_import, .handle = import_table});
    methods.add({.name = "ic.list", .handle = list_tables});
    methods.add({.name = "ic.delete", .handle = delete_tables});
}

}  // namespace contactd::server

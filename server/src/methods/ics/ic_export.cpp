#include "methods/handlers.hpp"

#include <array>
#include <memory>
#include <utility>

#include "contactd/ic_contents.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/strip_frames.hpp"
#include "engine/ics/ic_pair.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/costs.hpp"
#include "methods/costs/request_limits.hpp"

namespace contactd::server {

using engine::IcAnswer;
using engine::IcAnswers;

namespace {

/// Represents a file in progress: first the tables of both bodies, then the worker.
struct Export {
    CallPtr call;
    FileFormat format = FileFormat::hdf5;
    std::array<IcSpec, 2> specs;  // upper and lower body; equal for one body
    IcAnswers answers;
};
using ExportPtr = std::shared_ptr<Export>;

IcUse use_of(const IcAnswer& answer) {
    return {answer.origin, answer.key, answer.record->evidence};
}

/// Holds the file as a whole, or its parts.
void answer_with_ic_file(const Export& work) {
    const IcRecord& source = *work.answers[0].record;
    IcRecord record{work.specs[0], {}, source.evidence};
    if (record.spec.section)
        record.tables = source.tables;
    else
        record.tables = table_for(source, record.spec, 1, CallObserver(work.call));
    record.spec.any_nu = false;  // The exported file contains one table of the family.
    proto::ArrayWriter arrays(work.call->request.arrays);
    const IcUse use = use_of(work.answers[0]);
    const nlohmann::json result = work.format == FileFormat::contents
                                      ? proto::encode_contents_reply(contents_of(record), use, arrays)
                                      : proto::encode_hdf5_reply(to_ic_file(record), use, arrays);
    work.call->succeed(result, arrays.take_frames());
}

void answer_with_contact_text(const Export& work) {
    const auto& [upper, lower] = work.specs;
    const GivenIcs pair{pair_of(table_for(*work.answers[0].record, upper), table_for(*work.answers[1].record, lower)),
                        upper.dx, upper.dy};
    work.call->succeed(
        proto::encode_contact_text_reply(to_contact_text(pair, combined_modulus({upper.material, lower.material})),
                                         use_of(work.answers[0]), use_of(work.answers[1])));
}

void answer(const ExportPtr& work) {
    guarded(work->call, [&] {
        if (work->format == FileFormat::contact)
            answer_with_contact_text(*work);
        else
            answer_with_ic_file(*work);
    });
}

/// Checks the export of a longitudinally uniform body's table before anything is built.
void check_section(const IcExport& request, std::size_t most_bytes) {
    const IcSpec& spec = request.spec;
    if (request.format == FileFormat::contact)
        throw InvalidArgument("format",
                              "is contact, a format with offsets along x and y, but the table of a longitudinally "
                              "uniform body has none along y; use hdf5");
    if (spec.source == IcSource::analytic)
        throw InvalidArgument("ics.source", "is analytic, whose tables are faster to compute than to read: use ic.get");
    (void)strip_frames(spec);  // Reports a bad section in the lengths of the request.
    constexpr double bytes_per_value = 9 * sizeof(double);
    const double size = bytes_per_value * spec.nx * table_rows(spec);
    if (size > static_cast<double>(most_bytes))
        throw proto::invalid_field(
            "grid.nx",
            "and ny result in a table of " + std::to_string(static_cast<long long>(size)) + " bytes, but at most " +
                std::to_string(most_bytes) +
                " are allowed (limits.max_frame_bytes). The imported file serves every nx: set nx to 1",
            proto::reason::limit_exceeded);
}

void check_size(const IcSpec& spec, std::size_t most_bytes) {
    const double size = contact_text_size(spec.nx, spec.ny);
    if (size > static_cast<double>(most_bytes))
        throw proto::invalid_field("grid.nx",
                                   "and ny result in a text of " + std::to_string(static_cast<long long>(size)) +
                                       " bytes, but at most " + std::to_string(most_bytes) +
                                       " are allowed (limits.max_frame_bytes)",
                                   proto::reason::limit_exceeded);
}

}  // namespace

void export_table(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    const IcExport request = proto::decode_ic_export(call->request.params, call->request.frames);
    auto work = std::make_shared<Export>();
    work->call = call;
    work->format = request.format;
    work->specs.fill(request.spec);
    if (request.spec.section) check_section(request, parts.config.limits.max_frame_bytes);
    if (request.lower) work->specs[1].material = *request.lower;
    validate(work->specs[0], "material");
    validate(work->specs[1], "lower");
    if (request.format == FileFormat::contact) check_size(request.spec, parts.config.limits.max_frame_bytes);
    call->work.reset();  // a build may take hours
    const double bytes = cost_of_export(call->request.params, parts.config).bytes;
    fetch_pair(parts.ics, {work->specs[0], work->specs[1]},
               {[work, bytes, &parts](const IcAnswers& answers) {
                    work->answers = answers;
                    parts.budget.enter(work->call, bytes, [work, &workers = parts.workers] {
                        workers.post(ticket_of(work->call), [work] { answer(work); });
                    });
                },
                [call](const proto::Status& status) { call->fail(status); }, reports_to(call), ticket_of(call)});
}

}  // namespace contactd::server

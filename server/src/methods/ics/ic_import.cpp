#include "methods/handlers.hpp"

#include <utility>

#include "contactd/error.hpp"
#include "contactd/ic_contents.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/proto/import_codec.hpp"
#include "engine/ics/ic_import.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {
namespace {

IcRecord record_of(const proto::Request& request) {
    try {
        return record_from(proto::decode_file_contents(request.params, request.frames));
    } catch (const StoreError& error) {
        throw InvalidArgument("datasets", std::string("and attributes cannot be imported: ") + error.what());
    }
}

}  // namespace

void import_table(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    IcRecord record = record_of(call->request);
    CallObserver observer(call);
    call->succeed(proto::encode_import_reply(
        engine::import_table(std::move(record), parts.ics, call->user(), parts.engine.counters(), observer)));
}

}  // namespace contactd::server

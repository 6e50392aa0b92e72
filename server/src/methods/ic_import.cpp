#include "ic_import.hpp"

#include <utility>

#include "contactd/error.hpp"
#include "contactd/proto/import_codec.hpp"
#include "engine/ics/ic_import.hpp"

namespace contactd::server {
namespace {

IcRecord read(const std::vector<unsigned char>& bytes) {
    try {
        return from_ic_file(bytes, "the file");
    } catch (const DamagedTable& error) {
        throw InvalidArgument("file", std::string("cannot be imported: ") + error.what());
    }
}

}  // namespace

void import_table(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    IcRecord record = read(proto::decode_ic_import(call->request.params, call->request.frames));
    call->succeed(
        proto::encode_import_reply(engine::import_table(std::move(record), parts.ics, parts.engine.counters())));
}

}  // namespace contactd::server

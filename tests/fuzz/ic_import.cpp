// Fuzzes requests of ic.import, up to the record that the store would keep. They are refused with a message, or read; a
// read record is that of an elastic body, and the same after it is written and read again.
#include "contactd/error.hpp"
#include "contactd/ic_contents.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/stored_record.hpp"
#include "input.hpp"

using namespace contactd;
using namespace contactd::proto;

namespace {

void check_kept(const IcRecord& record) {
    const IcRecord again = record_from(contents_of(record));
    fuzz::require(again.spec == record.spec, "a spec that is kept is read as it was");
    fuzz::require(record.spec.dx == 1 && record.spec.material.G == 1, "what is kept has no dimensions");
    (void)dump(encode_import_reply({record.spec, {"file", ic_key(record.spec), record.evidence}, true}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    const auto params = nlohmann::json::parse(input.text, nullptr, false);
    if (params.is_discarded() || !violations_of("ic.import.params", params).empty()) return 0;
    const Frames frames(input.frames.begin(), input.frames.end());
    try {
        check_kept(stored_record(record_from(decode_file_contents(params, frames)), Observer()));
    } catch (const StatusError& error) {
        fuzz::require(error.status().message.size() < 2000, "a refusal is no longer than it must be");
    } catch (const InvalidArgument& error) {
        fuzz::require(!error.field().empty(), "a refusal names a field");
    } catch (const StoreError&) {
    }
    return 0;
}

#include "methods/handlers.hpp"

#include <algorithm>

#include "contactd/proto/codec.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

constexpr std::size_t most_with_evidence = 100;  // limits one answer, because each table requires reading a file

/// Uses whole names, so that a page may end between two extents of one key.
std::string name_of(const StoredTable& table) {
    return table.path.stem().string();
}

json to_json(const StoredTable& table, bool with_evidence) {
    json entry{{"key", table.key}, {"nx", table.nx}, {"ny", table.ny}, {"bytes", table.bytes}};
    if (with_evidence) try {
            entry["evidence"] = proto::encode_evidence(read_ic_file(table.path).evidence);
        } catch (const StoreError&) {
            // The file is damaged or was removed meanwhile, which a request for the table will report.
        }
    return entry;
}

json to_json(const engine::BuildQuarantine::Entry& entry) {
    const std::chrono::duration<double> left = entry.until - engine::BuildQuarantine::Clock::now();
    return {{"key", entry.key},
            {"nx", entry.nx},
            {"ny", entry.ny},
            {"failures", entry.failures},
            {"message", entry.last.message},
            {"seconds", std::max(0.0, left.count())}};
}

}  // namespace

void list_tables(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    const json& params = call->request.params;
    const std::string after = params.value("after", "");
    const bool with_evidence = params.value("evidence", false);
    std::size_t limit = params.value("limit", std::size_t(1000));
    if (with_evidence) limit = std::min(limit, most_with_evidence);
    const std::vector<StoredTable> tables = parts.ics.stored(call->user());
    json result{{"tables", json::array()}, {"count", tables.size()}, {"bytes", 0}, {"quarantined", json::array()}};
    std::uintmax_t bytes = 0;
    std::string last;
    for (const StoredTable& table : tables) {
        bytes += table.bytes;
        if (name_of(table) <= after || result.contains("next")) continue;
        if (result["tables"].size() == limit) {
            result["next"] = last;
            continue;
        }
        call->check_deadline();
        if (call->answered()) return;
        result["tables"].push_back(to_json(table, with_evidence));
        last = name_of(table);
    }
    result["bytes"] = bytes;
    for (const engine::BuildQuarantine::Entry& entry : parts.ics.quarantined())
        result["quarantined"].push_back(to_json(entry));
    call->succeed(result);
}

void delete_tables(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    const std::string key = call->request.params.at("key");
    const engine::IcService::Forgotten forgotten = parts.ics.forget(key, call->user());
    if (forgotten.tables == 0 && !forgotten.failures)
        throw proto::StatusError(
            proto::StatusCode::not_found, proto::reason::ic_unknown,
            "There is neither a table nor a failed build with the key " + key + "; call ic.list for existing keys.");
    call->succeed({{"key", key}, {"tables", forgotten.tables}, {"failures", forgotten.failures}});
}

}  // namespace contactd::server

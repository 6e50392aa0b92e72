#include "ic_import.hpp"

#include <string_view>
#include <utility>

#include "contactd/stored_record.hpp"
#include "engine/ics/store/store_folder.hpp"

namespace contactd::engine {
namespace {

constexpr std::string_view imported_sentence = "This table was imported from a file";

/// Adds the warning once, even if a table passes through several daemons.
void note_import(IcEvidence& evidence) {
    evidence.imported = true;
    std::erase_if(evidence.warnings, [](const std::string& warning) { return warning.starts_with(imported_sentence); });
    evidence.warnings.push_back(std::string(imported_sentence) + ". Its numbers have not been verified.");
}

}  // namespace

std::string imported_warning(const std::string& key) {
    return "The influence coefficients " + key.substr(0, 12) +
           "... were imported from a file and have not been verified.";
}

IcImport import_table(IcRecord imported, IcService& tables, const std::string& user, EngineCounters& counters,
                      const Observer& observer) {
    IcImport result{imported.spec, {"disk", ic_key(imported.spec), {}}, false};
    IcRecord record = stored_record(std::move(imported), observer);
    if (const auto known = tables.stored_for(record.spec, user)) {
        result.use.evidence = known->evidence;
        return result;
    }
    note_import(record.evidence);
    result.use.origin = "file";
    result.use.evidence = record.evidence;
    result.is_new = true;
    tables.keep_imported(std::move(record), user);
    count_store(counters, tables.store().folder());
    return result;
}

}  // namespace contactd::engine

#include "ic_import.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "contactd/stored_record.hpp"
#include "engine/ics/store/store_folder.hpp"

namespace contactd::engine {
namespace {

constexpr std::string_view imported_warning = "This table was imported from a file";

/// A table may go round several daemons.
void note_import(std::vector<std::string>& warnings) {
    std::erase_if(warnings, [](const std::string& warning) { return warning.starts_with(imported_warning); });
    warnings.push_back(std::string(imported_warning) +
                       "; that its numbers are those of its builder nobody has checked.");
}

}  // namespace

IcImport import_table(IcRecord imported, IcService& tables, Counters& counters) {
    IcImport result{imported.spec, {"disk", ic_key(imported.spec), {}}, false};
    IcRecord record = stored_record(std::move(imported));
    const IcStore& store = tables.store();
    if (const auto known = store.find(record.spec)) {
        result.use.evidence = known->evidence;
        return result;
    }
    note_import(record.evidence.warnings);
    if (const std::string problem = store.problem(); !problem.empty()) throw StoreError(problem);
    tables.forget(result.use.key);  // builds that failed do not matter any more
    const auto [nx, ny] = extent_of(record.tables);
    write_ic_file(store.path_of(result.use.key, nx, ny), record);
    store.remove_covered_by(record.spec);
    count_store(counters, store.folder());
    result.use.origin = "file";
    result.use.evidence = std::move(record.evidence);
    result.is_new = true;
    return result;
}

}  // namespace contactd::engine

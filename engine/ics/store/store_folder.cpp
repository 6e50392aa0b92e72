#include "store_folder.hpp"

#include "contactd/platform.hpp"

namespace contactd::engine {

namespace fs = std::filesystem;

void count_store(EngineCounters& counters, const fs::path& folder) {
    long long tables = 0, bytes = 0;
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        if (entry->path().extension() != ".h5") continue;
        std::error_code gone;  // Another daemon may have removed it meanwhile.
        const auto size = entry->file_size(gone);
        if (gone) continue;
        ++tables;
        bytes += static_cast<long long>(size);
    }
    counters.store_tables = tables;
    counters.store_bytes = bytes;
}

std::string store_problem(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error)) return "The store's folder " + folder.string() + " does not exist.";
    if (!fs::is_directory(folder, error)) return "store.folder is " + folder.string() + ", which is not a folder.";
    if (const std::error_code unusable = platform::cannot_use(folder, true))
        return "The store's folder " + folder.string() + " cannot be used: " + unusable.message() + ".";
    return {};
}

}  // namespace contactd::engine

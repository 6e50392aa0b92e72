#include "contactd/ic_store.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <system_error>
#include <vector>

namespace contactd {
namespace {

namespace fs = std::filesystem;

struct StoredName {
    fs::path path;
    int nx = 0;
    int ny = 0;
};

/// Reads "<key>.<nx>x<ny>.h5"; nothing for any other name.
std::optional<StoredName> parse(const fs::path& path, const std::string& key) {
    const std::string name = path.filename().string();
    if (!name.starts_with(key + ".") || !name.ends_with(".h5")) return std::nullopt;
    StoredName stored{path};
    const char* const end = name.data() + name.size() - 3;
    const auto [cross, x_error] = std::from_chars(name.data() + key.size() + 1, end, stored.nx);
    if (x_error != std::errc() || cross == end || *cross != 'x') return std::nullopt;
    const auto [rest, y_error] = std::from_chars(cross + 1, end, stored.ny);
    if (y_error != std::errc() || rest != end) return std::nullopt;
    return stored;
}

std::vector<StoredName> tables_with(const fs::path& folder, const std::string& key) {
    std::vector<StoredName> tables;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (auto stored = parse(entry.path(), key)) tables.push_back(std::move(*stored));
    return tables;
}

/// True when no living process writes the file: its writer holds a lock.
bool is_abandoned(const fs::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return false;
    const bool abandoned = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
    ::close(fd);
    return abandoned;
}

}  // namespace

IcStore::IcStore(fs::path folder, Report report) : folder_(std::move(folder)), report_(std::move(report)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || ::access(folder_.c_str(), R_OK | W_OK | X_OK) != 0)
        throw StoreError("The store's folder " + folder_.string() + " cannot be made or written to.");
}

fs::path IcStore::path_of(const IcSpec& spec) const {
    return folder_ / (ic_key(spec) + "." + std::to_string(spec.nx) + "x" + std::to_string(spec.ny) + ".h5");
}

std::optional<IcRecord> IcStore::find(const IcSpec& spec) const {
    const std::string key = ic_key(spec);
    std::vector<StoredName> tables = tables_with(folder_, key);
    std::erase_if(tables, [&](const StoredName& t) { return t.nx < spec.nx || t.ny < spec.ny; });
    std::sort(tables.begin(), tables.end(),
              [](const StoredName& a, const StoredName& b) { return 1LL * a.nx * a.ny < 1LL * b.nx * b.ny; });
    for (const StoredName& stored : tables) {
        try {
            IcRecord record = read_ic_file(stored.path);
            if (ic_key(record.spec) != key || record.spec.dx != 1 || record.spec.material.G != 1 ||
                record.table.nx != stored.nx || record.table.ny != stored.ny)
                throw DamagedTable(stored.path.string() + " does not hold the table its name promises.");
            return record;
        } catch (const DamagedTable& error) {
            const auto now = std::chrono::system_clock::now().time_since_epoch().count();
            const fs::path aside =
                folder_ / "quarantine" / (stored.path.filename().string() + "." + std::to_string(now));
            std::error_code failed;
            fs::create_directories(aside.parent_path(), failed);
            fs::rename(stored.path, aside, failed);
            if (failed) fs::remove(stored.path, failed);
            report_(std::string(error.what()) + " It was set aside as " + aside.string() + ".");
        } catch (const StoreError&) {
            if (fs::exists(stored.path)) throw;  // otherwise another process removed it meanwhile
        }
    }
    return std::nullopt;
}

void IcStore::remove_covered_by(const IcSpec& spec) const {
    std::error_code ignored;
    for (const StoredName& stored : tables_with(folder_, ic_key(spec)))
        if (stored.nx <= spec.nx && stored.ny <= spec.ny && (stored.nx != spec.nx || stored.ny != spec.ny))
            fs::remove(stored.path, ignored);
}

int IcStore::sweep() const {
    int swept = 0;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        if (entry.path().extension() == ".tmp" && entry.is_regular_file(ignored) && is_abandoned(entry.path()))
            swept += fs::remove(entry.path(), ignored);
    return swept;
}

}  // namespace contactd

#include "contactd/ic_store.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <format>
#include <system_error>
#include <vector>

#include "contactd/platform.hpp"
#include "store/hdf5/file_format.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view extension = ".h5", of_owner = "by-";

/// Returns the tag of a file that is stored beside one of a newer version.
std::string of_format() {
    return "format" + std::to_string(format_version);
}

/// Keeps letters, digits, - and _ of a name, and replaces other characters by their number.
std::string escaped(const TableOwner& owner) {
    std::string text;
    for (const char c : owner) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
        text += plain ? std::string(1, c) : std::format("={:02x}", static_cast<unsigned char>(c));
    }
    return text;
}

std::string unescaped(std::string_view text) {
    TableOwner owner;
    while (!text.empty()) {
        unsigned code = 0;
        const bool is_code = text.front() == '=' && text.size() > 2 &&
                             std::from_chars(text.data() + 1, text.data() + 3, code, 16).ptr == text.data() + 3;
        owner += is_code ? static_cast<char>(code) : text.front();
        text.remove_prefix(is_code ? 3 : 1);
    }
    return owner;
}

/// Reads "<key>.<nx>x<ny>.h5", or the same with the tag of an owner or of a format after the extent. Returns nothing
/// for any other name.
std::optional<StoredTable> parse(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::size_t key_size = name.find('.');
    if (key_size == std::string::npos || !name.ends_with(extension)) return std::nullopt;
    StoredTable stored;
    stored.path = path;
    stored.key = name.substr(0, key_size);
    if (!is_ic_key(stored.key)) return std::nullopt;
    if (name.size() <= key_size + extension.size()) return std::nullopt;
    const char* const end = name.data() + name.size() - extension.size();
    const auto [cross, x_error] = std::from_chars(name.data() + key_size + 1, end, stored.nx);
    if (x_error != std::errc() || cross == end || *cross != 'x') return std::nullopt;
    const auto [rest, y_error] = std::from_chars(cross + 1, end, stored.ny);
    if (y_error != std::errc()) return std::nullopt;
    if (rest == end) return stored;
    const std::string_view tag(rest + 1, end);
    if (*rest != '.' || !(tag.starts_with(of_owner) || tag == of_format())) return std::nullopt;
    if (tag.starts_with(of_owner)) stored.owner = unescaped(tag.substr(of_owner.size()));
    return stored;
}

/// Returns all tables, or those of one key, without sizes and times. Only regular files count, and links are not
/// followed.
std::vector<StoredTable> tables_in(const fs::path& folder, const std::string& key = "") {
    std::vector<StoredTable> tables;
    try {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            auto stored = parse(entry.path());
            std::error_code gone;
            if (stored && (key.empty() || stored->key == key) && fs::is_regular_file(entry.symlink_status(gone)))
                tables.push_back(std::move(*stored));
        }
    } catch (const fs::filesystem_error& error) {
        throw StoreError("The store's folder cannot be read: " + error.code().message() + ".");
    }
    return tables;
}

/// Returns the tables that serve a request, the smallest first.
std::vector<StoredTable> serving(const fs::path& folder, const std::string& key, const IcSpec& spec,
                                 const TableOwner& owner) {
    std::vector<StoredTable> tables = tables_in(folder, key);
    std::erase_if(tables, [&](const StoredTable& t) { return t.owner != owner || t.nx < spec.nx || t.ny < spec.ny; });
    std::sort(tables.begin(), tables.end(),
              [](const StoredTable& a, const StoredTable& b) { return 1LL * a.nx * a.ny < 1LL * b.nx * b.ny; });
    return tables;
}

bool is_of_newer_version(const fs::path& path) {
    try {
        (void)read_ic_file(path);
    } catch (const NewerFormat&) {
        return true;
    } catch (const StoreError&) {
        // The file is missing or damaged, so overwriting it loses nothing.
    }
    return false;
}

}  // namespace

std::string cannot_write(const fs::path& folder) {
    // Permissions are not reliable: they allow root to write where writing is impossible.
    const std::error_code error = platform::cannot_make_file(folder);
    return error ? error.message() : std::string();
}

IcStore::IcStore(fs::path folder, Report report) : folder_(std::move(folder)), report_(std::move(report)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || platform::cannot_use(folder_, false))
        throw StoreError("The store's folder " + folder_.string() + " cannot be created or read" +
                         (error ? ": " + error.message() + "." : "."));
}

std::string IcStore::problem() const {
    std::error_code error;
    fs::create_directories(folder_, error);
    const std::string why = error ? error.message() : cannot_write(folder_);
    return why.empty() ? why : "The store's folder is not writable: " + why + ".";
}

fs::path IcStore::path_of(const IcSpec& spec) const {
    return path_of(ic_key(spec), spec.nx, spec.ny);
}

fs::path IcStore::path_of(const std::string& key, int nx, int ny, const TableOwner& owner) const {
    const std::string name = std::format("{}.{}x{}", key, nx, ny);
    if (!owner.empty()) return folder_ / std::format("{}.{}{}{}", name, of_owner, escaped(owner), extension);
    return folder_ / (name + std::string(extension));
}

fs::path IcStore::path_to_write(const std::string& key, int nx, int ny, const TableOwner& owner) const {
    fs::path path = path_of(key, nx, ny, owner);
    if (is_of_newer_version(path))
        path.replace_filename(std::format("{}.{}x{}.{}{}", key, nx, ny, of_format(), extension));
    return path;
}

bool IcStore::may_have(const IcSpec& spec, const TableOwner& owner) const {
    return !serving(folder_, ic_key(spec), spec, owner).empty();
}

std::optional<IcRecord> IcStore::find(const IcSpec& spec, const TableOwner& owner) const {
    const std::string key = ic_key(spec);
    for (const StoredTable& stored : serving(folder_, key, spec, owner)) {
        try {
            IcRecord record = read_ic_file(stored.path);
            if (ic_key(record.spec) != key || record.spec.dx != 1 || record.spec.material.G != 1 ||
                extent_of(record.tables) != IcExtent{stored.nx, stored.ny})
                throw DamagedTable(stored.path.string() + " does not contain the table that its name identifies.");
            note_use(stored.path, time_of_use());
            return record;
        } catch (const DamagedTable& error) {
            const auto now = std::chrono::system_clock::now().time_since_epoch().count();
            const fs::path aside =
                folder_ / "quarantine" / (stored.path.filename().string() + "." + std::to_string(now));
            std::error_code failed;
            fs::create_directories(aside.parent_path(), failed);
            fs::rename(stored.path, aside, failed);
            if (failed) fs::remove(stored.path, failed);
            report_(std::string(error.what()) + " It was renamed to " + aside.string() + ".");
        } catch (const StoreError& error) {
            std::error_code ignored;
            // Otherwise another process has removed it meanwhile.
            if (fs::exists(stored.path, ignored)) report_(error.what());
        }
    }
    return std::nullopt;
}

void IcStore::remove_covered_by(const IcSpec& spec, const TableOwner& owner) const {
    std::error_code ignored;
    for (const StoredTable& stored : tables_in(folder_, ic_key(spec))) {
        const bool is_covered = stored.owner == owner && stored.nx <= spec.nx && stored.ny <= spec.ny &&
                                (stored.nx != spec.nx || stored.ny != spec.ny);
        if (is_covered && !is_of_newer_version(stored.path)) fs::remove(stored.path, ignored);
    }
}

std::vector<StoredTable> IcStore::list() const {
    std::vector<StoredTable> tables = tables_in(folder_);
    std::erase_if(tables, [](StoredTable& stored) {
        std::error_code error;
        stored.bytes = fs::file_size(stored.path, error);
        if (!error) stored.last_use = fs::last_write_time(stored.path, error);
        return bool(error);  // It was removed meanwhile.
    });
    std::sort(tables.begin(), tables.end(),
              [](const StoredTable& a, const StoredTable& b) { return a.path.native() < b.path.native(); });
    return tables;
}

int IcStore::remove(const std::string& key, const TableOwner& owner) const {
    int removed = 0;
    for (const StoredTable& stored : tables_in(folder_, key)) {
        if (!stored.owner.empty() && stored.owner != owner) continue;
        std::error_code error;
        removed += fs::remove(stored.path, error);
        if (error) throw StoreError("Cannot remove " + stored.path.filename().string() + ": " + error.message() + ".");
    }
    return removed;
}

}  // namespace contactd

// Defines the IC store: a folder with one HDF5 file per dimensionless table. Links, FIFOs and devices in it are
// ignored.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/ic_spec.hpp"

namespace contactd {

/// Returns the SHA-256 (hex) of the canonical JSON text of the dimensionless spec without its extent. It is equal for
/// every shear modulus, every element size and every extent.
std::string ic_key(const IcSpec& spec);
/// Returns whether `text` has the form of a key: 64 hexadecimal digits.
bool is_ic_key(std::string_view text);

/// Writes `record` so that `path` is never incomplete: writes a temporary file in the same folder, flushes it, renames
/// it, and flushes the folder. The first 512 bytes (an HDF5 user block) contain the SHA-256 of the rest. Throws
/// StoreError.
void write_ic_file(const std::filesystem::path& path, const IcRecord& record);

/// The content of a file differs from the written content.
class DamagedTable : public StoreError {
   public:
    using StoreError::StoreError;
};

/// A file was written by a newer version; this version does not change it.
class NewerFormat : public StoreError {
   public:
    using StoreError::StoreError;
};

/// Reads a file after checking its digest. Throws DamagedTable if the content is not that of an IC file written by
/// write_ic_file, NewerFormat, and StoreError if the file cannot be read or is not a regular file, for example a link.
IcRecord read_ic_file(const std::filesystem::path& path);
/// Reads the content of a file; `path` is its name in exceptions.
IcRecord from_ic_file(std::span<const unsigned char> bytes, const std::filesystem::path& path);

/// Returns the system's reason why no file can be created in the folder, by creating one; empty if it is possible.
std::string cannot_write(const std::filesystem::path& folder);

/// Names the user who imported a table. It is empty for tables built by contactd, which all users share. In file names,
/// characters other than letters, digits, - and _ are replaced by = and their two hexadecimal digits.
using TableOwner = std::string;

/// Describes a file of the store.
struct StoredTable {
    std::filesystem::path path;
    std::string key;
    TableOwner owner;
    int nx = 0;
    int ny = 0;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type last_use;  ///< time of the last write or read
};

/// A store is safe to use from several threads and, on one folder, from several processes.
class IcStore {
   public:
    /// The store calls this with a sentence if a file is set aside.
    using Report = std::function<void(const std::string&)>;

    /// Creates the folder if it is missing. Throws StoreError if it cannot be created or read. A folder without write
    /// permission can still be read.
    IcStore(std::filesystem::path folder, Report report);

    /// Returns the smallest stored table of the owner with the key of `spec` that covers its extent, if any. A file
    /// that fails its check is moved to `quarantine/`, reported, and not considered again. A file that cannot be
    /// read, or was written by a newer version, is reported and ignored. Throws StoreError if the folder cannot be
    /// read.
    std::optional<IcRecord> find(const IcSpec& spec, const TableOwner& owner = {}) const;
    /// Returns whether there is a file whose name find() would consider.
    bool may_have(const IcSpec& spec, const TableOwner& owner = {}) const;

    /// Returns the path of the table of `spec`: <key>.<nx>x<ny>.h5, with an owner <key>.<nx>x<ny>.by-<owner>.h5.
    std::filesystem::path path_of(const IcSpec& spec) const;
    std::filesystem::path path_of(const std::string& key, int nx, int ny, const TableOwner& owner = {}) const;
    /// Returns that path, or if a newer version has a file with this name, <key>.<nx>x<ny>.format<n>.h5, with the
    /// format n of this version. It reads the file.
    std::filesystem::path path_to_write(const std::string& key, int nx, int ny, const TableOwner& owner = {}) const;
    /// Returns the path of the lock file of a running build with this key.
    std::filesystem::path lock_of(const std::string& key) const { return folder_ / (key + ".lock"); }

    /// Removes tables of the owner that the table of `spec` covers, except itself and those of newer versions.
    void remove_covered_by(const IcSpec& spec, const TableOwner& owner = {}) const;

    using Time = std::filesystem::file_time_type;
    /// Marks a table for evict as used at that time, unless it was used later. find() calls it.
    void note_use(const std::filesystem::path& path, Time used) const;
    /// Returns the time to record for a use now: the wall-clock time, but later than all earlier ones. If the clock was
    /// set back, times of use in the future are moved back, as by settle_times().
    Time time_of_use() const;
    /// Moves times of use in the future to the present, in their order, so that later uses count as later. Such times
    /// come from clocks that were ahead, or from versions that counted from the year 2174.
    void settle_times() const;

    /// Returns all tables, sorted by name. Throws StoreError if the folder cannot be read.
    std::vector<StoredTable> list() const;

    /// Removes the tables of a key without owner, or those of `owner`, and returns their number. Throws StoreError if
    /// one cannot be removed.
    int remove(const std::string& key, const TableOwner& owner = {}) const;

    /// Creates the folder again if it was removed. Returns a sentence if it cannot be written to.
    std::string problem() const;

    /// Removes temporary files and build locks of ended processes, and returns their number. Files whose name does not
    /// begin with a key are left alone.
    int sweep() const;

    /// Removes files until the total is at most `budget_bytes`: first damaged ones that were set aside, then tables in
    /// the order of their last use by any process. Those whose key is in `kept` are not removed. Returns the removed
    /// tables.
    std::vector<StoredTable> evict(std::uintmax_t budget_bytes, const std::vector<std::string>& kept) const;

    const std::filesystem::path& folder() const { return folder_; }

   private:
    struct Latest {
        std::mutex mutex;
        Time time = Time::min();  // not Time{}, which is the year 2174
    };
    std::filesystem::path folder_;
    Report report_;
    std::shared_ptr<Latest> latest_ = std::make_shared<Latest>();  ///< latest time of use that was given
};

}  // namespace contactd

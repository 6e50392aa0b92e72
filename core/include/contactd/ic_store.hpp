// The IC store: a folder with one HDF5 file per dimensionless table. Links, FIFOs and devices in it are passed over.
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

/// SHA-256 (hex) of the canonical JSON text of the dimensionless spec without its extent: equal for every shear
/// modulus, every element size and every extent.
std::string ic_key(const IcSpec& spec);
/// Whether `text` has the form of a key: 64 hexadecimal digits.
bool is_ic_key(std::string_view text);

/// Writes `record` so that `path` either does not exist or is whole: temporary file in the same folder, fsync, rename,
/// fsync of the folder. The first 512 bytes (an HDF5 user block) hold the SHA-256 of the rest. Throws StoreError.
void write_ic_file(const std::filesystem::path& path, const IcRecord& record);

/// The content of a file is not what was written.
class DamagedTable : public StoreError {
   public:
    using StoreError::StoreError;
};

/// A file was written by a version that knows more than this one, which leaves it alone.
class NewerFormat : public StoreError {
   public:
    using StoreError::StoreError;
};

/// Reads a file, checking its digest before HDF5 sees a byte. Throws DamagedTable when the content is not that of an IC
/// file written by write_ic_file, NewerFormat, and StoreError when the file cannot be read at all, or is a link or
/// anything else but a regular file.
IcRecord read_ic_file(const std::filesystem::path& path);
/// Reads the content of a file; `path` is for the words of the exception.
IcRecord from_ic_file(std::span<const unsigned char> bytes, const std::filesystem::path& path);

/// Why no file can be made in the folder, in the system's words, found out by making one; empty when one can.
std::string cannot_write(const std::filesystem::path& folder);

/// Who has brought a table: empty of those that contactd built itself, which serve everybody. In the names of files
/// other characters than letters, digits, - and _ stand as = and their two hexadecimal digits.
using TableOwner = std::string;

/// A file of the store.
struct StoredTable {
    std::filesystem::path path;
    std::string key;
    TableOwner owner;
    int nx = 0;
    int ny = 0;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type last_use;  ///< when it was written or last read
};

/// Safe to use from several threads and, on one folder, from several processes.
class IcStore {
   public:
    /// Called with a sentence when a file is set aside.
    using Report = std::function<void(const std::string&)>;

    /// Makes the folder when it is missing. Throws StoreError when it cannot be made or read; one that cannot be
    /// written to is good for what is in it.
    IcStore(std::filesystem::path folder, Report report);

    /// The smallest stored table of the owner with the key of `spec` that covers its extent, or nothing. A file that
    /// fails its check is moved to `quarantine/`, reported, and not considered again; one that cannot be read, or was
    /// written by a newer version, is reported and passed over. Throws StoreError when the folder itself cannot be
    /// read.
    std::optional<IcRecord> find(const IcSpec& spec, const TableOwner& owner = {}) const;
    /// Whether there is a file by a name that find() would look into.
    bool may_have(const IcSpec& spec, const TableOwner& owner = {}) const;

    /// Where the table of `spec` belongs: <key>.<nx>x<ny>.h5, of an owner <key>.<nx>x<ny>.by-<owner>.h5.
    std::filesystem::path path_of(const IcSpec& spec) const;
    std::filesystem::path path_of(const std::string& key, int nx, int ny, const TableOwner& owner = {}) const;
    /// Returns that path, or where a newer version keeps a file of its own under this name,
    /// <key>.<nx>x<ny>.format<n>.h5, of the format n of this version. Looks into the file.
    std::filesystem::path path_to_write(const std::string& key, int nx, int ny, const TableOwner& owner = {}) const;
    /// The file that says that somebody builds a table with this key.
    std::filesystem::path lock_of(const std::string& key) const { return folder_ / (key + ".lock"); }

    /// Removes tables of the owner that the one of `spec` covers, itself and those of newer versions excepted.
    void remove_covered_by(const IcSpec& spec, const TableOwner& owner = {}) const;

    using Time = std::filesystem::file_time_type;
    /// Marks a table as used at that time, for evict, unless it was used later. find() does so by itself.
    void note_use(const std::filesystem::path& path, Time used) const;
    /// The time of a use that happens now: the wall clock's, and later than any that was given before. Where the clock
    /// was set back, times of use that lie in its future now are brought back, as by settle_times().
    Time time_of_use() const;
    /// Brings times of use that lie in the future to the present, in their order, so that what is used from now on
    /// counts as used after them: those of clocks that were ahead, or of versions that counted from the year 2174.
    void settle_times() const;

    /// Every table, by name. Throws StoreError when the folder cannot be read.
    std::vector<StoredTable> list() const;

    /// Removes the tables of a key that nobody has brought, or that `owner` has; returns how many. Throws StoreError
    /// when one cannot be removed.
    int remove(const std::string& key, const TableOwner& owner = {}) const;

    /// Makes the folder again when somebody removed it. What keeps it from being written to, as a sentence, or nothing.
    std::string problem() const;

    /// Removes what dead processes left, temporary files and locks of builds; returns how many files. Files whose name
    /// does not begin with a key are nobody's business here.
    int sweep() const;

    /// Removes files until all together need no more than `budget_bytes`: first damaged ones that were set aside, then
    /// tables by their last use, by whichever process. Those whose key is in `kept` stay. Returns the tables that went.
    std::vector<StoredTable> evict(std::uintmax_t budget_bytes, const std::vector<std::string>& kept) const;

    const std::filesystem::path& folder() const { return folder_; }

   private:
    struct Latest {
        std::mutex mutex;
        Time time = Time::min();  // not Time{}, which is the year 2174
    };
    std::filesystem::path folder_;
    Report report_;
    std::shared_ptr<Latest> latest_ = std::make_shared<Latest>();  ///< time of use that was given
};

}  // namespace contactd

// The IC store: a folder with one HDF5 file per dimensionless table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// A table with what it is and how it was made.
struct IcRecord {
    IcSpec spec;  ///< dimensionless, its extent that of the table
    IcTable table;
    IcEvidence evidence;
    /// When spec.any_nu: one table for each of evidence.family_nu; `table` then is the first of them.
    std::vector<IcTable> family;
};

/// SHA-256 (hex) of the canonical JSON text of the dimensionless spec without its extent: equal for every shear
/// modulus, every element size and every extent.
std::string ic_key(const IcSpec& spec);

/// Writes `record` so that `path` either does not exist or is whole: temporary file in the same folder, fsync, rename,
/// fsync of the folder. The first 512 bytes (an HDF5 user block) hold the SHA-256 of the rest. Throws StoreError.
void write_ic_file(const std::filesystem::path& path, const IcRecord& record);

/// The content of a file is not what was written.
class DamagedTable : public StoreError {
   public:
    using StoreError::StoreError;
};

/// Reads a file, checking its digest before HDF5 sees a byte. Throws DamagedTable when the content is not that of an IC
/// file written by write_ic_file, StoreError when the file cannot be read at all.
IcRecord read_ic_file(const std::filesystem::path& path);

/// Safe to use from several threads and, on one folder, from several processes.
class IcStore {
   public:
    /// Called with a sentence when a file is set aside.
    using Report = std::function<void(const std::string&)>;

    /// Makes the folder when it is missing. Throws StoreError when it cannot be used.
    IcStore(std::filesystem::path folder, Report report);

    /// The smallest stored table with the key of `spec` that covers its extent, or nothing. A file that fails its check
    /// is moved to `quarantine/`, reported, and not considered again.
    std::optional<IcRecord> find(const IcSpec& spec) const;

    /// Where the table of `spec` belongs: <key>.<nx>x<ny>.h5.
    std::filesystem::path path_of(const IcSpec& spec) const;

    /// Removes tables that the one of `spec` covers, itself excepted.
    void remove_covered_by(const IcSpec& spec) const;

    /// Removes temporary files that no living process is writing; returns how many.
    int sweep() const;

    const std::filesystem::path& folder() const { return folder_; }

   private:
    std::filesystem::path folder_;
    Report report_;
};

}  // namespace contactd

// What is kept of influence coefficients: tables of one kind or another, with what they are and how they were made.
// Cache, requests in flight, store and exchange know the functions below and no kind. A new kind is one more
// alternative of IcTables, for which the compiler asks these functions what they do.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// Tables over Poisson's ratio, one for each of evidence.family_nu, of one extent.
struct IcFamily {
    std::vector<IcTable> tables;
};

/// For G = 1 and dx = 1.
using IcTables = std::variant<IcTable, IcFamily>;

struct IcRecord {
    IcSpec spec{};  ///< dimensionless, its extent that of the tables
    IcTables tables{};
    IcEvidence evidence{};

    /// The only table; of a family the first.
    const IcTable& table() const;
    IcTable& table();
};

/// Numbers of offsets.
struct IcExtent {
    int nx = 0, ny = 0;

    bool covers(const IcExtent& other) const { return nx >= other.nx && ny >= other.ny; }
    bool operator==(const IcExtent&) const = default;
};
IcExtent extent_of(const IcTables& tables);

/// What the numbers take in memory.
std::size_t bytes_of(const IcTables& tables);

/// The table that `request` asks for, of its Poisson's ratio, extent and units (mm^3/N), made in one pass. Throws
/// InvalidArgument when the record is smaller, or "material.nu" is none of a family's, and StoreError for a family that
/// was computed at other points than family_points().
IcTable table_for(const IcRecord& record, const IcSpec& request);

}  // namespace contactd

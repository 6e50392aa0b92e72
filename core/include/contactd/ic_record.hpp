// Records of influence coefficients: tables of one kind or another, with what they are and how they were made. Cache,
// requests in flight, store and exchange know the functions of IcTables and no kind. A new kind is one more
// alternative, with functions of its own beside it that the compiler asks for.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"
#include "contactd/strip_spectrum.hpp"
#include "contactd/strip_table.hpp"

namespace contactd {

/// Tables over Poisson's ratio, one for each of evidence.family_nu, of one extent.
struct IcFamily {
    std::vector<IcTable> tables;
};

/// For G = 1 and dx = 1; a longitudinally uniform body's spectrum for ds = 1, and any dx.
using IcTables = std::variant<IcTable, IcFamily, StripTable, StripSpectrum>;

struct IcRecord {
    IcSpec spec{};  ///< dimensionless, its extent that of the tables
    IcTables tables{};
    IcEvidence evidence{};

    /// The only table of offsets; of a family the first. Not of a longitudinally uniform body.
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

/// Returns the memory that the numbers take.
std::size_t bytes_of(const IcTables& tables);

/// The table that operators are made of: the coefficients of one body in mm^3/N, on the grid of a problem. There are
/// kinds of these, too; bodies of unlike kinds meet in make_influence.
using BodyTable = std::variant<IcTable, StripTable>;

/// Returns the table that `request` asks for, of its Poisson's ratio, extent and units, made in one pass. Throws
/// InvalidArgument when the record is smaller, or "material.nu" is none of a family's, and StoreError for a family that
/// was computed at other points than family_points(), and Cancelled. `threads`: at most as many, for what is large.
BodyTable body_table(const IcRecord& record, const IcSpec& request, int threads = 1, const Observer& observer = {});
/// Returns the table as ic.get answers it: that of a longitudinally uniform body with table_rows() rows. Throws
/// NotFinite when a coefficient is beyond a double's range.
IcTable table_for(const IcRecord& record, const IcSpec& request, int threads = 1, const Observer& observer = {});

}  // namespace contactd

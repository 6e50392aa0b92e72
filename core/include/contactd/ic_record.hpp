// Defines records of influence coefficients: tables of any kind, with their specification and evidence. Cache, running
// requests, store and exchange only use the functions of IcTables. A new kind is another alternative; the compiler
// reports the functions that it needs.
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

/// Holds tables of one extent, one for each Poisson's ratio in evidence.family_nu.
struct IcFamily {
    std::vector<IcTable> tables;
};

/// Tables are for G = 1 and dx = 1. The spectrum of a longitudinally uniform body is for ds = 1 and any dx.
using IcTables = std::variant<IcTable, IcFamily, StripTable, StripSpectrum>;

struct IcRecord {
    IcSpec spec{};  ///< dimensionless; its extent is that of the tables
    IcTables tables{};
    IcEvidence evidence{};

    /// Returns the table of offsets, or the first one of a family. Not valid for a longitudinally uniform body.
    const IcTable& table() const;
    IcTable& table();
};

/// Holds numbers of offsets.
struct IcExtent {
    int nx = 0, ny = 0;

    bool covers(const IcExtent& other) const { return nx >= other.nx && ny >= other.ny; }
    bool operator==(const IcExtent&) const = default;
};
IcExtent extent_of(const IcTables& tables);

/// Returns the memory of the numbers in bytes.
std::size_t bytes_of(const IcTables& tables);

/// Operators are made from this table: the coefficients of one body in mm^3/N, on the grid of a problem. There are
/// several kinds; make_influence combines bodies of different kinds.
using BodyTable = std::variant<IcTable, StripTable>;

/// Returns the table of `request`, with its Poisson's ratio, extent and units, made in one pass. Throws InvalidArgument
/// if the record is smaller or "material.nu" is outside a family's range, StoreError if a family was computed at points
/// other than family_points(), and Cancelled. `threads` is the largest number of threads, for large tables.
BodyTable body_table(const IcRecord& record, const IcSpec& request, int threads = 1, const Observer& observer = {});
/// Returns the table as in answers of ic.get, with table_rows() rows for a longitudinally uniform body. Throws
/// NotFinite if a coefficient is beyond a double's range.
IcTable table_for(const IcRecord& record, const IcSpec& request, int threads = 1, const Observer& observer = {});

}  // namespace contactd

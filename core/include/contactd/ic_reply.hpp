// Defines answers with tables of influence coefficients, and the origin of the tables of a solve.
#pragma once

#include <optional>
#include <string>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// Holds the answer of ic.get.
struct IcReply {
    std::string key;
    std::string origin;  ///< "closed_form", "memory", "disk" or "built"
    IcSpec spec;         ///< the request with its defaults
    IcTable table;       ///< in mm^3/N, cropped to the request; ny is table_rows() of the spec
    IcEvidence evidence;
    std::vector<StripFrame> frames{};  ///< frames of the strips of a longitudinally uniform body
};

/// Describes the origin of the coefficients of one body.
struct IcUse {
    std::string origin;  ///< as in IcReply, or "given" if the request contained them
    std::string key;
    IcEvidence evidence;
};

/// Describes the origins of the coefficients of a contact problem; simplified models have none.
struct IcUses {
    std::optional<IcUse> upper{}, lower{};  ///< absent for a rigid body
    std::optional<IcUse> pair{};            ///< instead of these, if the request contained a table of the pair
};

/// Holds the answer of ic.export: the file of one body in the store (docs/ic-tables.md), its parts as ic.import accepts
/// them, or the text of a pair of bodies for the CONTACT program.
enum class FileFormat { hdf5, contents, contact };

struct IcExport {
    IcSpec spec;
    std::optional<Material> lower;  ///< material of the second body, for CONTACT's text; absent: equal to the first
    FileFormat format = FileFormat::hdf5;
};

}  // namespace contactd

// Tables of influence coefficients as they are answered, and where those of a solve came from.
#pragma once

#include <optional>
#include <string>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// A table, as ic.get answers it.
struct IcReply {
    std::string key;
    std::string origin;  ///< "closed_form", "memory", "disk" or "built"
    IcSpec spec;         ///< as requested, defaults filled in
    IcTable table;       ///< in mm^3/N, cropped to the request; ny is table_rows() of the spec
    IcEvidence evidence;
    std::vector<StripFrame> frames{};  ///< of the strips of a longitudinally uniform body
};

/// Where the coefficients of one body came from.
struct IcUse {
    std::string origin;  ///< as of IcReply, or "given" when the request brought them
    std::string key;
    IcEvidence evidence;
};

/// Those of a contact problem: none of the simplified models.
struct IcUses {
    std::optional<IcUse> upper{}, lower{};  ///< not of a rigid body
    std::optional<IcUse> pair{};            ///< instead of these, when the request brought those of both together
};

/// The answer of ic.export: the file of one body that the store holds (docs/ic-tables.md), its parts as ic.import takes
/// them, or the text that the CONTACT program reads, of a pair of bodies.
enum class FileFormat { hdf5, contents, contact };

struct IcExport {
    IcSpec spec;
    std::optional<Material> lower;  ///< of the second body, for CONTACT's text; else it is as the first
    FileFormat format = FileFormat::hdf5;
};

}  // namespace contactd

// JSON <-> the plain types of core. Used by the server, by contactd-ic and by the C++ client, so that each message is
// written and read in one place.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

// --- ic.get; contactd-ic reads the same object from a file ---------------------------------------------------------
nlohmann::json encode_ic_spec(const IcSpec& spec);
/// `params` has passed its schema. Applies preset and defaults; ranges are checked by contactd::validate.
IcSpec decode_ic_spec(const nlohmann::json& params);

struct IcReply {
    std::string key;
    std::string origin;  ///< "closed_form", "memory", "disk" or "built"
    IcSpec spec;         ///< as requested, defaults filled in
    IcTable table;       ///< in mm^3/N, cropped to the request
    IcEvidence evidence;
};
nlohmann::json encode_ic_reply(const IcReply& reply, ArrayWriter& arrays);
IcReply decode_ic_reply(const nlohmann::json& result, const std::vector<std::string>& frames);

nlohmann::json encode_evidence(const IcEvidence& evidence);
IcEvidence decode_evidence(const nlohmann::json& json);

// --- contact.solve ---------------------------------------------------------------------------------------------------
/// Writes the gap as an array.
nlohmann::json encode_problem(const ContactProblem& problem, ArrayWriter& arrays);
/// `params` has passed its schema. Throws StatusError naming the field for a grid that is too large (before anything of
/// its size is allocated) and for arrays that do not fit; the rest is checked by contactd::validate.
ContactProblem decode_problem(const nlohmann::json& params, const std::vector<std::string>& frames);

/// Where the coefficients of a solve came from.
struct IcUse {
    std::string origin;
    std::string key;
    IcEvidence evidence;
};
struct SolveReply {
    ContactSolution solution;
    IcUse upper, lower;
    std::optional<IcUse> pair;  ///< instead of these, when the request held the coefficients
};
nlohmann::json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays);
SolveReply decode_solve_reply(const nlohmann::json& result, const std::vector<std::string>& frames);

// --- ic.export -------------------------------------------------------------------------------------------------------
enum class FileFormat { hdf5, contact };

struct IcExport {
    IcSpec spec;
    std::optional<Material> lower;  ///< of the second body, for CONTACT's text; else it is as the first
    FileFormat format = FileFormat::hdf5;
};
/// `params` has passed its schema.
IcExport decode_ic_export(const nlohmann::json& params);
nlohmann::json encode_hdf5_reply(std::span<const unsigned char> file, const IcUse& body, ArrayWriter& arrays);
nlohmann::json encode_contact_text_reply(std::string text, const IcUse& upper, const IcUse& lower);

}  // namespace contactd::proto

// JSON <-> the plain types of core. Used by the server, by contactd-ic and by the C++ client, so that each message is
// written and read in one place.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/subsurface.hpp"

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
nlohmann::json encode_problem(const ContactProblem& problem, ArrayWriter& arrays);
/// `params` has passed its schema. Throws StatusError naming the field for a grid that is too large (before anything of
/// its size is allocated) and for arrays that do not fit; the rest is checked by contactd::validate. Of the models
/// other than full, which do not use it, `ics` is not read.
ContactProblem decode_problem(const nlohmann::json& params, const std::vector<std::string>& frames);

/// Where the coefficients of a solve came from.
struct IcUse {
    std::string origin;
    std::string key;
    IcEvidence evidence;
};
struct SolveReply {
    ContactSolution solution;
    std::optional<IcUse> upper, lower;  ///< of the full model; not of a rigid body
    std::optional<IcUse> pair;          ///< instead of these, when the request held the coefficients
};
nlohmann::json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays);
SolveReply decode_solve_reply(const nlohmann::json& result, const std::vector<std::string>& frames);

// --- contact.solve_many ----------------------------------------------------------------------------------------------
using ProblemOrStatus = std::variant<ContactProblem, Status>;
using ReplyOrStatus = std::variant<SolveReply, Status>;

nlohmann::json encode_problems(std::span<const ContactProblem> problems, ArrayWriter& arrays);
/// `params` has passed its schema. Instead of a problem that decode_problem refuses comes the reason, with fields as of
/// contact.solve. Throws StatusError (LIMIT_EXCEEDED) when the arrays of all problems together, a frame counted as
/// often as it is named, have more than limits.max_array_elements: each problem gets arrays of its own.
std::vector<ProblemOrStatus> decode_problems(const nlohmann::json& params, const std::vector<std::string>& frames,
                                             const Limits& limits = {});

/// `grids` are those of the problems; of one that failed it does not matter. A reply that cannot be sent, because a
/// number in it is not finite, becomes INTERNAL.
nlohmann::json encode_solve_replies(std::span<const ReplyOrStatus> replies, std::span<const Grid> grids,
                                    ArrayWriter& arrays);
std::vector<ReplyOrStatus> decode_solve_replies(const nlohmann::json& result, const std::vector<std::string>& frames);

// --- contact.subsurface ----------------------------------------------------------------------------------------------
using StressPoints = std::vector<std::array<double, 3>>;

/// Stresses inside one body of a contact problem. Points are in the frame of that body (contactd/subsurface.hpp).
struct SubsurfaceRequest {
    Grid grid;
    double nu = 0;  ///< Poisson's ratio of the body, 0 to 0.5
    ContactBody body = ContactBody::lower;
    Ics ics;  ///< that the tractions were solved with; those of a body that is no half-space are refused
    /// Of a contact solution, for either body: the tractions are those on the upper one. Shape [ny, nx] (N/mm^2);
    /// tractions may be empty, which means zero.
    std::vector<double> pressure, traction_x, traction_y;
    std::variant<StressPoints, StressBlock> points;

    std::vector<std::size_t> shape() const;                ///< of the results: [n], or [nz, ny, nx] of a block
    std::array<double, 3> point(std::size_t index) const;  ///< the point of a result
};
/// Where the von Mises stress is largest.
struct LargestStress {
    double von_mises = 0;           ///< (N/mm^2)
    std::array<double, 3> point{};  ///< x, y, z (mm)

    double depth() const { return 0 - point[2]; }  ///< (mm)
};
struct SubsurfaceReply {
    SubsurfaceStress stress;
    std::vector<std::size_t> shape;  ///< of all its arrays
    LargestStress largest;
};
nlohmann::json encode_subsurface_request(const SubsurfaceRequest& request, ArrayWriter& arrays);
/// `params` has passed its schema. Throws StatusError naming the field for a grid or points that are too many
/// (LIMIT_EXCEEDED; the arrays of the result have at most limits.max_array_elements together), before anything of their
/// size is allocated, for arrays that do not fit and a body that is no
/// half-space; the rest is checked by contactd::subsurface_stress.
SubsurfaceRequest decode_subsurface_request(const nlohmann::json& params, const std::vector<std::string>& frames,
                                            const Limits& limits = {});
nlohmann::json encode_subsurface_reply(const SubsurfaceReply& reply, ArrayWriter& arrays);
SubsurfaceReply decode_subsurface_reply(const nlohmann::json& result, const std::vector<std::string>& frames);

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

// Encodes the messages of wheelrail.solve, wheelrail.wheelset and wheelrail.geometry (docs/wheel-rail.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/conicity.hpp"
#include "contactd/contact.hpp"
#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::proto {

// --- wheelrail.solve -------------------------------------------------------------------------------------------------
/// Contents that are requested of an answer: its patches, and these arrays of each.
struct PatchFields {
    SolutionFields solution = all_solution_fields;
    bool gap = false;
    bool patches = true;
};

/// Bodies are sent as materials of half-spaces. Throws InvalidArgument ("setup.bodies") for others.
nlohmann::json encode_wheel_rail_request(const WheelRailSetup& setup, const WheelRailState& state,
                                         const PatchFields& fields, ArrayWriter& arrays);
nlohmann::json encode_wheel_rail_setup(const WheelRailSetup& setup, ArrayWriter& arrays);
/// Reads `setup` of params that have passed their schema; defaults if there is none. Throws StatusError naming the
/// field for too many points, before memory is allocated, and for arrays that do not match; contactd::validate and
/// make_profile check the rest.
WheelRailSetup decode_wheel_rail_setup(const nlohmann::json& params, const Frames& frames);
nlohmann::json encode_wheel_rail_friction(const WheelRailFriction& friction);
WheelRailFriction decode_wheel_rail_friction(const nlohmann::json& friction);
PatchFields decode_patch_fields(const nlohmann::json& params);

/// Returns the text of a solution as JSON. Throws Error for numbers that are not finite.
std::string write_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields,
                                      ArrayWriter& arrays);
nlohmann::json encode_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields,
                                          ArrayWriter& arrays);
WheelRailSolution decode_wheel_rail_solution(const nlohmann::json& result, const Frames& frames);
WheelRailSolution decode_wheel_rail_solution(const AnswerValue& result, const Frames& frames);

// --- wheelrail.wheelset ----------------------------------------------------------------------------------------------
nlohmann::json encode_wheelset_request(const WheelsetSetup& setup, const WheelsetState& state,
                                       const PatchFields& fields, ArrayWriter& arrays);
/// `setup` and `left` of params that have passed their schema. Throws as decode_wheel_rail_setup.
WheelsetSetup decode_wheelset_setup(const nlohmann::json& params, const Frames& frames);
nlohmann::json encode_wheelset_solution(const WheelsetSolution& solution, const PatchFields& fields,
                                        ArrayWriter& arrays);
WheelsetSolution decode_wheelset_solution(const nlohmann::json& result, const Frames& frames);

// --- wheelrail.geometry ----------------------------------------------------------------------------------------------
nlohmann::json encode_geometry_request(const WheelRailSetup& setup, std::span<const WheelRailState> states,
                                       ArrayWriter& arrays);
nlohmann::json encode_wheel_rail_geometries(std::span<const WheelRailGeometry> geometries);
std::vector<WheelRailGeometry> decode_wheel_rail_geometries(const nlohmann::json& result);

nlohmann::json encode_conicity_request(const WheelsetSetup& setup, const ConicityRequest& requested,
                                       ArrayWriter& arrays);
nlohmann::json encode_contacts_request(const WheelsetSetup& setup, const ContactsRequest& requested,
                                       ArrayWriter& arrays);
nlohmann::json encode_profiles_request(const WheelsetSetup& setup, ArrayWriter& arrays);
/// `conicities` of a result. Numbers that are not finite are omitted, and become NaN in the client.
nlohmann::json encode_conicities(std::span<const EquivalentConicity> conicities);
std::vector<EquivalentConicity> decode_conicities(const nlohmann::json& conicities);
/// `contacts` of a result.
nlohmann::json encode_contacts(std::span<const WheelsetContacts> contacts);
std::vector<WheelsetContacts> decode_contacts(const nlohmann::json& contacts);
/// `profiles` of a result.
nlohmann::json encode_profiles(const ProfilesOfSides& profiles, ArrayWriter& arrays);
ProfilesOfSides decode_profiles(const nlohmann::json& profiles, const Frames& frames);

}  // namespace contactd::proto

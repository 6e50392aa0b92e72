// The messages of wheelrail.solve and wheelrail.geometry (docs/wheel-rail.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/conicity.hpp"
#include "contactd/contact.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::proto {

// --- wheelrail.solve -------------------------------------------------------------------------------------------------
/// The arrays that patches of an answer shall hold.
struct PatchFields {
    SolutionFields solution = all_solution_fields;
    bool gap = false;
};

/// Bodies are told by their materials, as half-spaces. Throws InvalidArgument ("setup.bodies") for others.
nlohmann::json encode_wheel_rail_request(const WheelRailSetup& setup, const WheelRailState& state,
                                         const PatchFields& fields, ArrayWriter& arrays);
/// `setup` of params that have passed their schema; defaults where there is none. Throws StatusError naming the field
/// for points that are too many, before anything of their size is allocated, and for arrays that do not fit; the rest
/// is checked by contactd::validate and make_profile.
WheelRailSetup decode_wheel_rail_setup(const nlohmann::json& params, const std::vector<std::string>& frames);
nlohmann::json encode_wheel_rail_state(const WheelRailState& state);
WheelRailState decode_wheel_rail_state(const nlohmann::json& state);
PatchFields decode_patch_fields(const nlohmann::json& params);

/// Throws Error for numbers that are not finite.
nlohmann::json encode_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields,
                                          ArrayWriter& arrays);
WheelRailSolution decode_wheel_rail_solution(const nlohmann::json& result, const std::vector<std::string>& frames);

// --- wheelrail.geometry ----------------------------------------------------------------------------------------------
nlohmann::json encode_geometry_request(const WheelRailSetup& setup, std::span<const WheelRailState> states,
                                       ArrayWriter& arrays);
nlohmann::json encode_wheel_rail_geometries(std::span<const WheelRailGeometry> geometries);
std::vector<WheelRailGeometry> decode_wheel_rail_geometries(const nlohmann::json& result);

nlohmann::json encode_conicity_request(const WheelRailSetup& setup, const ConicityRequest& wanted, ArrayWriter& arrays);
/// `conicity` of params that have passed their schema.
ConicityRequest decode_conicity(const nlohmann::json& conicity);
/// `conicities` of a result. What is not finite is left out, and not a number on the other side.
nlohmann::json encode_conicities(std::span<const EquivalentConicity> conicities);
std::vector<EquivalentConicity> decode_conicities(const nlohmann::json& conicities);

}  // namespace contactd::proto

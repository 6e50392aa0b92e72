// A wheel on its rail: what was set, and what came of the last solve.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "answers/rail_places.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "handles/contact_case.hpp"

namespace contactd::cntc {

/// Tractions of all patches among them: too much to copy in each step. Null: there are none.
using SharedEstimates = std::shared_ptr<const WheelRailEstimates>;

struct RailCase {
    std::mutex mutex;  ///< held by whoever uses the rest
    RailSettings settings;
    std::unique_ptr<const WheelRailContact> contact{};  ///< kept as long as the set-up stays
    std::shared_ptr<const RailOutlines> outlines{};     ///< that somebody asked for last
    SharedEstimates before{}, estimates{};              ///< where the last step started, and where the next one does
    std::optional<WheelRailState> state{};              ///< of the last solve
    std::optional<WheelRailSolution> solution{};        ///< of the last solve
    bool current = false;  ///< whether it is what was asked for last: a refused case cannot be read
};

/// Throws Refused where the last case was not solved.
const WheelRailSolution& solution_of(const RailCase& rail);

/// Solves what is set, and keeps it. Throws Refused, where searches and solvers missed their tolerances with what they
/// found kept. `common` is what wheel on rail has in common with basic contact.
void calculate(RailCase& rail, const Settings& common);

/// Patches of the solution, from the field side to the gauge side.
std::vector<const WheelRailPatch*> ordered_patches(const RailCase& rail);

/// By the set-up that was solved last, or else by what is set.
const RailOutlines& outlines_of(RailCase& rail, const Settings& common);
RailFrames frames_of(RailCase& rail, const Settings& common);

/// Makes a contact problem of a patch, for the functions that answer what there is of one. Its blocks stay.
void show(const WheelRailPatch& patch, const RailCase& rail, const Settings& common, ProblemCase& problem);

}  // namespace contactd::cntc

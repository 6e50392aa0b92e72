// A wheel on its rail: its settings, and the results of the last solve.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "answers/rail_places.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "handles/contact_case.hpp"
#include "run/rail_history.hpp"

namespace contactd::cntc {

struct RailCase {
    std::mutex mutex;  ///< guards the other members
    RailSettings settings;
    std::unique_ptr<const WheelRailContact> contact{};  ///< kept as long as the set-up stays
    std::shared_ptr<const RailOutlines> outlines{};     ///< that somebody asked for last
    RailHistory history{};
    std::optional<WheelRailState> state{};        ///< of the last solve
    std::optional<WheelRailSolution> solution{};  ///< of the last solve
    bool current = false;  ///< true if it belongs to the last request; a refused case has no results
};

/// Returns the solution. Throws Refused if the last case was not solved.
const WheelRailSolution& solution_of(const RailCase& rail);

/// Solves the current settings and stores the solution. Throws Refused; after a missed tolerance of a search or a
/// solver the solution is stored nevertheless. `common` contains the settings shared with basic contact.
void calculate(RailCase& rail, const Settings& common);

/// Returns the patches of the solution, from the field side to the gauge side.
std::vector<const WheelRailPatch*> ordered_patches(const RailCase& rail);

/// Returns the outlines for the set-up of the last solve or, without one, for the current settings.
const RailOutlines& outlines_of(RailCase& rail, const Settings& common);
RailFrames frames_of(RailCase& rail, const Settings& common);

/// Makes a contact problem from a patch, for the functions that return its results. Its blocks of points are kept.
void show(const WheelRailPatch& patch, const RailCase& rail, const Settings& common, ProblemCase& problem);

}  // namespace contactd::cntc

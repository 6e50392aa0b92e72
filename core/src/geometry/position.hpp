// Represents a right wheel on its rail in one position: their contacts and distances.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contactd/friction.hpp"
#include "contactd/gap.hpp"
#include "contactd/observer.hpp"
#include "contactd/profile.hpp"
#include "contactd/profile_evidence.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/motion/creepages.hpp"
#include "geometry/search/overlap_search.hpp"
#include "geometry/search/patch_grid.hpp"
#include "geometry/search/regions.hpp"

namespace contactd::geometry {

/// Holds profiles of the right side; y ascends along both.
struct Profiles {
    ProfileCurve wheel, rail;
    ProfilePoint rail_origin;
    std::shared_ptr<const SlicedRail> slices{};        ///< instead of the rail
    std::shared_ptr<const OutOfRound> out_of_round{};  ///< in addition to the wheel's profile, which is that of its
                                                       ///< first slice
    std::vector<std::string> wheel_warnings{}, rail_warnings{};  ///< see ProfileEvidence, or for all slices
    std::optional<WheelLandmarks> landmarks{};                   ///< landmarks of the wheel, or of its first slice
};

/// Makes the profiles. Throws InvalidArgument ("wheel.points[i]", "rail.points", ...) if the setup's profiles cannot be
/// used, and Cancelled if the observer, which is called for each slice, cancels.
Profiles make_profiles(const WheelRailSetup& setup, const Observer& observer = {});

/// This observer never cancels a search.
inline const Observer no_observer{};

struct CandidatePatch {
    ContactPlace place;
    std::vector<double> gap;  ///< see WheelRailPatch; empty until measured, and if a paraboloid replaces it
    Paraboloid paraboloid{};
    double row_on_rail = 0, row_on_wheel = 0;  ///< arc lengths of the first row along the profiles (mm)
    Grid needed{};                             ///< grid that the overlap needs, without additional elements
    std::optional<Grid> touches{};             ///< elements that may be in contact, if these are not all elements of
                                               ///< the grid
    ElementMiddle middle;                      ///< position of elements
    ElementMiddle counted_from;          ///< origin of counting elements in the plane; the reference for steady rolling
    int more_below = 0, more_above = 0;  ///< additional rows of a curved contact
    std::vector<RowSlip> row_slips;      ///< only for rigid slip by surfaces
    RigidSlip additional_slip;           ///< for curved contacts: slip of each element in addition to the creepages
    double rail_speed = 0;               ///< speed at which the rail's surface passes through the contact (mm/s)
    SlopesAlong slopes{};                ///< slopes of the rail, if forces follow them
    QualityFlags quality{};
};

/// Functions take z as an argument and ignore position.z of the state.
class Position {
   public:
    /// All arguments must outlive this object. Here and later, the observer may end a search or a measurement with
    /// Cancelled.
    Position(const WheelRailSetup& setup, const Profiles& profiles, const WheelRailState& state,
             const Observer& observer = no_observer);
    Position(const Position&) = delete;

    /// Returns the least vertical distance (mm), negative where wheel and rail overlap, infinite if they are not above
    /// each other.
    double clearance(double z) const { return search_->least_gap() - z; }
    /// Returns candidates from right to left, without gaps. Approaches are those of the search: vertical penetrations
    /// seen along the normal.
    std::vector<CandidatePatch> candidates(double z) const;
    /// Returns a place where the rail meets the wheel outside all candidates, because the search does not consider it.
    std::optional<PassedOver> passed_over(double z) const { return search_->passed_over(z); }
    /// Computes gap and approach at the elements, and dependent values; simplified models need nothing more. Returns
    /// false if no element has wheel and rail along its normal, so that there is no contact.
    bool measure(CandidatePatch& found, double z) const;
    /// Extends a candidate to the elements of this grid, of which it already has a part, or to fewer where a curved
    /// contact ends. Throws InvalidArgument ("dx") for too many.
    void widen(CandidatePatch& found, const Grid& grid, double z) const;
    /// Returns the normal force that Hertz's theory expects for the regions, in the track's z (N); `compliance` is as
    /// in hertz.hpp.
    double expected_force(double z, double compliance) const;
    const RailSurface& rail() const { return rail_; }
    WheelSurface wheel(double z) const { return wheel_.lowered(z); }

   private:
    CandidatePatch candidate_of(const RegionGroup& group, const WheelSurface& wheel, double z) const;
    void find_elements(CandidatePatch& found) const;
    void take_creepages(CandidatePatch& found, const WheelSurface& wheel) const;
    std::vector<RegionGroup> groups(double z, bool blends) const;
    double spin_ahead(const ContactPlace& place) const;
    int most_elements() const;
    bool bend(CandidatePatch& found, const WheelSurface& wheel) const;

    const WheelRailSetup& setup_;
    const WheelRailState& state_;
    const Observer& observer_;
    WheelSurface wheel_;  // at z = 0
    RailSurface rail_;
    std::unique_ptr<OverlapSearch> search_;
};

}  // namespace contactd::geometry

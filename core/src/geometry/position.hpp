// A right wheel on its rail in one position: where they touch, and how far they are apart there.
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

/// Profiles of the right side; y ascends along both.
struct Profiles {
    ProfileCurve wheel, rail;
    ProfilePoint rail_origin;
    std::shared_ptr<const SlicedRail> slices{};        ///< in place of the rail
    std::shared_ptr<const OutOfRound> out_of_round{};  ///< beside the wheel's profile, which is that of its first slice
    std::vector<std::string> wheel_warnings{}, rail_warnings{};  ///< as of ProfileEvidence, or of all slices
    std::optional<WheelLandmarks> landmarks{};                   ///< of the wheel, or its first slice
};

/// Throws InvalidArgument ("wheel.points[i]", "rail.points", ...) where the setup's profiles cannot be used, and
/// Cancelled when the observer, which is asked slice by slice, says so.
Profiles make_profiles(const WheelRailSetup& setup, const Observer& observer = {});

/// For who never ends a search.
inline const Observer no_observer{};

struct CandidatePatch {
    ContactPlace place;
    std::vector<double> gap;  ///< as in WheelRailPatch; empty until measured, and where a paraboloid stands for it
    Paraboloid paraboloid{};
    double row_on_rail = 0, row_on_wheel = 0;  ///< arc lengths of the first row along the profiles (mm)
    Grid needed{};                             ///< what the overlap needs, with no more elements beside it
    std::optional<Grid> touches{};             ///< elements that may be in contact, where not all of the grid's may
    ElementMiddle middle;                      ///< where elements lie
    ElementMiddle counted_from;  ///< where they are counted from, in the plane; the reference, of steady rolling
    int more_below = 0, more_above = 0;  ///< rows of a curved contact beside those that it needs
    std::vector<RowSlip> row_slips;      ///< of rigid slip by surfaces only
    RigidSlip additional_slip;           ///< of curved contacts: beside the creepages, of each element
    double rail_speed = 0;               ///< at which its surface passes through the contact (mm/s)
    SlopesAlong slopes{};                ///< of the rail, where forces follow them
    QualityFlags quality{};
};

/// position.z of the state is that of no function here, but an argument.
class Position {
   public:
    /// All must live longer. Here and later the observer may have a search or a measurement end with Cancelled.
    Position(const WheelRailSetup& setup, const Profiles& profiles, const WheelRailState& state,
             const Observer& observer = no_observer);
    Position(const Position&) = delete;

    /// Least vertical distance (mm), negative where wheel and rail overlap; infinite where they are not above each
    /// other.
    double clearance(double z) const { return search_->least_gap() - z; }
    /// From the right to the left, still without gaps: approaches are those of the search, vertical penetrations seen
    /// along the normal.
    std::vector<CandidatePatch> candidates(double z) const;
    /// Returns where the rail meets the wheel beside all candidates, because the search does not look there.
    std::optional<PassedOver> passed_over(double z) const { return search_->passed_over(z); }
    /// Takes gap and approach at the elements, and what follows from them; of simplified models nothing is left to do.
    /// False where no element has wheel and rail along its normal: that is no place of contact.
    bool measure(CandidatePatch& found, double z) const;
    /// Gives a candidate the elements of this grid, of which it has a part already; fewer where a curved contact ends.
    /// Throws InvalidArgument ("dx") for too many.
    void widen(CandidatePatch& found, const Grid& grid, double z) const;
    /// The normal force that Hertz's theory expects of the regions, in the track's z (N); `compliance` as in hertz.hpp.
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

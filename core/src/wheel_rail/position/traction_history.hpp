// Tractions that a step which is not steady goes on from.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Tractions of the patches before on the elements of those that are now, which move, grow, merge and split: each
/// element's go to the patch that is nearest. None is lost but what lies farther from it than that is large.
class TractionHistory {
   public:
    /// The elements of the patches are those that they touch by, before they are widened. By the motion of the state
    /// elements move with the wheelset, or are fixed to the rail.
    TractionHistory(const std::vector<WheelRailEstimates::Patch>& before,
                    const std::vector<geometry::CandidatePatch>& now, const WheelRailState& state,
                    PatchHistory parts = PatchHistory::own);

    /// Tells whether a patch has tractions that others have, too: those of a patch that split, wanted whole.
    bool shares(std::size_t patch) const { return patches_[patch].shares; }
    /// Returns the grid of a patch with the elements that its tractions lie on.
    Grid widened(std::size_t patch) const;
    /// On the elements of the problem of a patch; empty where there are none. What particles carry beside tractions is
    /// there if its friction asks for that.
    SurfaceState on(std::size_t patch, const ContactProblem& problem) const;
    /// How large a force (N) is left behind, on elements too far away.
    double force_left_behind() const { return left_behind_; }

   private:
    /// Elements on the rail are counted by multiples of their sizes.
    struct Elements {
        long long x = 0, y = 0;
        int nx = 0, ny = 0;

        long long beside(long long ix, long long iy) const;  ///< how many elements away the farther coordinate is
    };
    struct Traction {
        long long x, y;
        double pressure, along, across;
        std::optional<double> yield_stress{}, friction_coefficient{};
    };
    struct Patch {
        Grid grid;
        RailPlace on_rail;
        Elements elements;
        std::vector<Traction> tractions{};
        bool is_curved = false, shares = false;
    };

    static Elements elements_of(const Grid& grid, const RailPlace& on_rail);
    Patch* nearest(long long ix, long long iy);
    void share_whole(const std::vector<Traction>& whole, const std::vector<Patch*>& owners);

    std::vector<Patch> patches_;
    double left_behind_ = 0;
};

}  // namespace contactd

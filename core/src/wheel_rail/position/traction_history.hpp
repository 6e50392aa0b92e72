// Determines the tractions from which a transient step starts.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/fields/grid_arrays.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Maps the tractions of previous patches to the elements of current ones, which move, grow, merge and split. The
/// tractions of each element go to the nearest patch. They are lost only if their distance exceeds the size of that
/// patch.
class TractionHistory {
   public:
    /// The elements of the patches are those in contact, before patches are widened. Depending on the motion of the
    /// state, elements move with the wheelset or are fixed to the rail.
    TractionHistory(const std::vector<WheelRailEstimates::Patch>& before,
                    const std::vector<geometry::CandidatePatch>& now, const WheelRailState& state,
                    PatchHistory parts = PatchHistory::own);

    /// Returns whether a patch shares tractions with others, because a previous patch was split.
    bool shares(std::size_t patch) const { return patches_[patch].shares; }
    /// Returns the grid of a patch, extended to the elements of its tractions.
    Grid widened(std::size_t patch) const;
    /// Returns the tractions on the elements of a patch's problem, or none. They include other state of particles if
    /// the friction law requires it.
    SurfaceState on(std::size_t patch, const ContactProblem& problem) const;
    /// Returns the force (N) lost on elements that are too far away.
    double force_left_behind() const { return left_behind_; }

   private:
    /// Describes positions of elements on the rail as multiples of their sizes.
    struct Elements {
        long long x = 0, y = 0;
        int nx = 0, ny = 0;

        long long beside(long long ix, long long iy) const;  ///< number of elements to the farther coordinate
    };
    /// Holds the values of an element in the order of history_arrays; state of particles may be unknown.
    struct Traction {
        long long x, y;
        std::array<std::optional<double>, std::tuple_size_v<decltype(history_arrays)>> values{};
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

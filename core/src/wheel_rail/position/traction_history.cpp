#include "traction_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace contactd {
namespace {

/// Returns a value, or zero if there are none.
double value_at(const std::vector<double>& values, std::size_t i) {
    return values.empty() ? 0 : values[i];
}

/// Returns the state of particles that have not been in contact. State that friction does not keep is empty.
SurfaceState untouched(const ContactProblem& problem) {
    SurfaceState state;
    for (const HistoryArray& array : history_arrays) {
        std::vector<double>& values = state.*array.before;
        if (array.is_traction()) values.resize(problem.grid.size());
        if (array.is_traction() || !problem.friction || !array.is_kept(*problem.friction)) continue;
        for (std::size_t i = 0; i < problem.grid.size(); ++i) values.push_back(*array.entering(*problem.friction, i));
    }
    return state;
}

}  // namespace

TractionHistory::TractionHistory(const std::vector<WheelRailEstimates::Patch>& before,
                                 const std::vector<geometry::CandidatePatch>& now, const WheelRailState& state,
                                 PatchHistory parts) {
    const bool moves = state.motion != WheelRailMotion::shift;
    const auto seen = [moves](RailPlace place, double x) {
        if (moves) place.along -= x;
        return place;
    };
    for (const geometry::CandidatePatch& found : now) {
        const Grid& grid = found.place.grid;
        const RailPlace on_rail = seen(found.place.on_rail, state.position.x);
        patches_.push_back({grid, on_rail, elements_of(grid, on_rail), {}, !found.place.rows.empty()});
    }
    for (const WheelRailEstimates::Patch& patch : before) {
        if (patches_.empty() || patch.grid.dx != patches_[0].grid.dx || patch.grid.dy != patches_[0].grid.dy) continue;
        const Elements elements = elements_of(patch.grid, seen(patch.on_rail, patch.x));
        std::vector<Traction> whole;
        std::vector<Patch*> owners;  // owner of each traction
        for (std::size_t i = 0; i < patch.grid.size(); ++i) {
            const double along = value_at(patch.tractions.traction_x, i);
            const double across = value_at(patch.tractions.traction_y, i);
            if (value_at(patch.tractions.pressure, i) == 0 && along == 0 && across == 0) continue;
            const long long ix = elements.x + static_cast<int>(i) % elements.nx;
            const long long iy = elements.y + static_cast<int>(i) / elements.nx;
            if (Patch* owner = nearest(ix, iy)) {
                owners.push_back(owner);
                Traction& traction = whole.emplace_back(Traction{ix, iy});
                for (std::size_t k = 0; k < history_arrays.size(); ++k) {
                    const std::vector<double>& values = patch.tractions.*history_arrays[k].before;
                    if (history_arrays[k].is_traction() || !values.empty()) traction.values[k] = value_at(values, i);
                }
            } else {
                left_behind_ += std::hypot(along, across) * patch.grid.element_area();
            }
        }
        const bool splits = std::adjacent_find(owners.begin(), owners.end(), std::not_equal_to<>()) != owners.end();
        if (parts == PatchHistory::whole && splits)
            share_whole(whole, owners);
        else
            for (std::size_t i = 0; i < whole.size(); ++i) owners[i]->tractions.push_back(whole[i]);
    }
}

/// Gives the whole to all parts that are curved, and to the first one of those in planes.
void TractionHistory::share_whole(const std::vector<Traction>& whole, const std::vector<Patch*>& owners) {
    bool is_first = true;
    for (Patch& patch : patches_) {
        if (std::find(owners.begin(), owners.end(), &patch) == owners.end()) continue;
        patch.shares = is_first || patch.is_curved;
        is_first = false;
        for (std::size_t i = 0; i < whole.size(); ++i)
            if (patch.shares || owners[i] == &patch) patch.tractions.push_back(whole[i]);
    }
}

long long TractionHistory::Elements::beside(long long ix, long long iy) const {
    return std::max({0LL, x - ix, ix - (x + nx - 1), y - iy, iy - (y + ny - 1)});
}

// The first element is rounded, and the others follow it, because elements of steady rolling are centred on their
// reference.
TractionHistory::Elements TractionHistory::elements_of(const Grid& grid, const RailPlace& on_rail) {
    return {std::llround((on_rail.along + grid.x(0)) / grid.dx), std::llround((on_rail.across + grid.y(0)) / grid.dy),
            grid.nx, grid.ny};
}

TractionHistory::Patch* TractionHistory::nearest(long long ix, long long iy) {
    Patch* best = nullptr;
    long long least = 0;
    for (Patch& patch : patches_) {
        const long long away = patch.elements.beside(ix, iy);
        const auto& [x, y, nx, ny] = patch.elements;
        if (away > std::max(nx, ny) || (best != nullptr && away >= least)) continue;
        best = &patch;
        least = away;
    }
    return best;
}

Grid TractionHistory::widened(std::size_t patch) const {
    const Patch& now = patches_[patch];
    const auto& [x, y, nx, ny] = now.elements;
    long long left = 0, right = 0, below = 0, above = 0;
    for (const Traction& traction : now.tractions) {
        left = std::max(left, x - traction.x);
        right = std::max(right, traction.x - (x + nx - 1));
        below = std::max(below, y - traction.y);
        above = std::max(above, traction.y - (y + ny - 1));
    }
    Grid grid = now.grid;
    grid.x0 -= static_cast<double>(left) * grid.dx;
    grid.y0 -= static_cast<double>(below) * grid.dy;
    grid.nx += static_cast<int>(left + right);
    grid.ny += static_cast<int>(below + above);
    return grid;
}

SurfaceState TractionHistory::on(std::size_t patch, const ContactProblem& problem) const {
    const Grid& grid = problem.grid;
    const Patch& now = patches_[patch];
    if (now.tractions.empty()) return {};
    const Elements elements = elements_of(grid, now.on_rail);
    SurfaceState state = untouched(problem);
    for (const Traction& traction : now.tractions) {
        if (elements.beside(traction.x, traction.y) > 0) continue;
        const std::size_t i =
            static_cast<std::size_t>(traction.y - elements.y) * static_cast<std::size_t>(elements.nx) +
            static_cast<std::size_t>(traction.x - elements.x);
        for (std::size_t k = 0; k < history_arrays.size(); ++k) {
            std::vector<double>& values = state.*history_arrays[k].before;
            if (traction.values[k] && !values.empty()) values[i] = *traction.values[k];
        }
    }
    return state;
}

}  // namespace contactd

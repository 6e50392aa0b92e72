#include <algorithm>
#include <array>
#include <iterator>
#include <list>
#include <mutex>
#include <utility>

#include "bodies/rotated_influence.hpp"
#include "contactd/half_space.hpp"
#include "contactd/patch_influence.hpp"
#include "wheel_rail/patches/curved_size.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_sizes = 64;
constexpr std::size_t most_elements_of_sizes = 100'000;  // limit for all together, about 50 MB

/// Returns operators of adjacent rows of half-spaces with constant loads.
ContactInfluence flat_influence(const ContactProblem& problem, const Observer& observer) {
    const Grid& grid = problem.grid;
    const auto half_space = [&](const Material& material) -> IcTable {
        if (material.is_rigid()) return {grid.nx, grid.ny};
        return half_space_table({Ics{}, material, grid.dx, grid.dy, grid.nx, grid.ny}, observer);
    };
    const auto [rail, wheel] = problem.bodies.materials();
    return make_influence(problem, pair_of(half_space(rail), half_space(wheel)), observer);
}

}  // namespace

struct RotatedPatches::Kept {
    /// Holds everything on which the kept data depends.
    struct Key {
        MaterialPair bodies;
        int nx, ny;
        std::array<double, 4> lengths;  ///< lengths of the elements and of the step

        explicit Key(const ContactProblem& problem)
            : bodies(problem.bodies.materials()), nx(problem.grid.nx), ny(problem.grid.ny) {
            const auto [step_x, step_y] = step_of(problem);
            lengths = {problem.grid.dx, problem.grid.dy, step_x, step_y};
        }
        bool operator==(const Key& other) const {
            return bodies.upper == other.bodies.upper && bodies.lower == other.bodies.lower && nx == other.nx &&
                   ny == other.ny && lengths == other.lengths;
        }
        std::size_t elements() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    };
    struct Size {
        Key key;
        std::shared_ptr<const MidwayInfluence> midway;
    };
    std::mutex mutex;       // guards the following members
    std::list<Size> sizes;  // most recently used first

    void forget_oldest() {
        std::size_t elements = 0, count = 0;
        for (auto size = sizes.begin(); size != sizes.end();) {
            elements += size->key.elements();
            const bool goes = ++count > 1 && (count > most_sizes || elements > most_elements_of_sizes);
            size = goes ? sizes.erase(size) : std::next(size);
        }
    }
};

RotatedPatches::RotatedPatches() : kept_(std::make_unique<Kept>()) {}
RotatedPatches::~RotatedPatches() = default;

ContactInfluence RotatedPatches::of(const ContactProblem& problem, const PatchStrips& strips, const Observer& observer,
                                    const std::function<ContactInfluence()>& flat) {
    check_curved_size(problem.grid);
    const Kept::Key key(problem);
    const std::lock_guard lock(kept_->mutex);
    auto& sizes = kept_->sizes;
    const auto found = std::find_if(sizes.begin(), sizes.end(), [&](const auto& size) { return size.key == key; });
    if (found != sizes.end()) {
        sizes.splice(sizes.begin(), sizes, found);
    } else {
        ContactInfluence side_by_side = flat ? flat() : flat_influence(problem, observer);
        sizes.push_front({key, std::make_shared<const MidwayInfluence>(
                                   midway_influence(problem, std::move(side_by_side), observer))});
        kept_->forget_oldest();
    }
    return rotated_influence(problem, *sizes.front().midway, strips.frames);
}

}  // namespace contactd

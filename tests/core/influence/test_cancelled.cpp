// Tests that long computations end soon after their observer cancels them.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>

#include "contactd/half_space.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/rotated_strips.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "contactd/subsurface.hpp"
#include "geometry/position.hpp"
#include "influence/layered/shifted_layers.hpp"
#include "influence/shifted_table.hpp"
#include "influence/strips/wavenumber_rule.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

/// Cancels at the call of this number.
class EndedAt final : public Observer {
   public:
    explicit EndedAt(int question) : left_(question) {}
    bool cancelled() const override { return --left_ <= 0; }
    int left() const { return left_; }

   private:
    mutable int left_;
};

/// Counts the calls of `work`, at least `least`, and cancels at some of them.
void check_asks(int least, const std::function<void(Observer&)>& work) {
    constexpr int never = 1'000'000;
    EndedAt counts(never);
    work(counts);
    const int asked = never - counts.left();
    CHECK(asked >= least);
    for (const int question : {1, asked / 2, asked}) {
        if (question < 1) continue;
        EndedAt ends(question);
        CHECK_THROWS_AS(work(ends), Cancelled);
        CHECK(ends.left() == 0);  // no calls and no work follow
    }
}

const Material steel{82000, 0.28};

IcSpec spec(int nx, int ny) {
    IcSpec result;
    result.material = steel;
    result.dx = result.dy = 0.5;
    result.nx = nx;
    result.ny = ny;
    return result;
}

}  // namespace

TEST_CASE("Tables of coefficients are ended row by row") {
    const Grid grid = Grid::of_elements(7, 9, 0.5, 0.4);
    check_asks(9, [](Observer& observer) { half_space_table(spec(7, 9), observer); });
    check_asks(18, [&](Observer& observer) {
        rotated_strips(Section{Slab{100, 100}}, grid, steel, LoadShape::constant, 0, "section", observer);
    });
    check_asks(17, [&](Observer& observer) {
        shifted_half_spaces({{steel, steel}, LoadShape::constant, {}}, grid, 0.2, 0.1, observer);
    });
    Layers body;
    body.layers = {{1, 500, 0.3}};
    body.base = steel;
    check_asks(9, [&](Observer& observer) { shifted_layers(body, LoadShape::constant, grid, 0.2, 0.1, observer); });
    check_asks(5, [](Observer& observer) { wavenumber_rule(wavenumber_nodes(0.1, 8, 5), 0.1, 1, 20, 0, observer); });
}

TEST_CASE("Stresses on a raster are ended row by row") {
    const Grid grid = Grid::of_elements(20, 20, 1, 1);
    std::vector<double> pressure;
    for (std::size_t i = 0; i < grid.size(); ++i) pressure.push_back(1 + std::sin(static_cast<double>(i * i)));
    StressBlock block;
    for (int i = 0; i < 20; ++i) block.x.push_back(grid.x(i)), block.y.push_back(grid.y(i));
    block.z = {-1};
    check_asks(20, [&](Observer& observer) { subsurface_stress(grid, {{}, {}, pressure}, 0.3, block, observer); });
}

TEST_CASE("Searches for contacts are ended, and reading profiles of slices") {
    WheelRailSetup setup = cylinder_on_arc(300);
    WheelRailState state;
    state.position.z = 0.05;
    for (const ContactSearch search : {ContactSearch::locus, ContactSearch::mesh}) {
        setup.patches.search = search;
        const geometry::Profiles profiles = geometry::make_profiles(setup);
        check_asks(4, [&](Observer& observer) {
            const geometry::Position position(setup, profiles, state, observer);
            for (geometry::CandidatePatch& place : position.candidates(0.05)) position.measure(place, 0.05);
        });
    }
    for (int i = 0; i < 5; ++i) setup.rail_slices.push_back({10.0 * i, setup.rail});
    check_asks(5, [&](Observer& observer) { geometry::make_profiles(setup, observer); });
}

// Arrays that a step passes on to the next.
#include <catch2/catch_test_macros.hpp>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "contactd/fields/contact.hpp"
#include "contactd/fields/grid_arrays.hpp"

using namespace contactd;

TEST_CASE("The end of a step has each array of the history", "[history]") {
    ContactSolution solution;
    double value = 0;
    for (const HistoryArray& array : history_arrays) solution.*array.after = {++value};
    const SurfaceState expected{{1}, {2}, {3}, {4}, {5}};
    CHECK(end_of(solution) == expected);
    CHECK(end_of(std::move(solution)) == expected);
}

TEST_CASE("A friction law keeps only state that it changes", "[history]") {
    FrictionLaw law;
    law.mu = {0.3, 0.4};
    const auto kept = [&] {
        std::vector<std::string_view> names;
        for (const HistoryArray& array : history_arrays)
            if (!array.is_traction() && array.is_kept(law)) names.push_back(array.name);
        return names;
    };
    using Names = std::vector<std::string_view>;
    CHECK(kept() == Names{});
    law.layer = InterfacialLayer{1e-5, 120, 0};
    law.kinetic.emplace();
    CHECK(kept() == Names{});
    law.layer->hardening = 10;
    law.kinetic->memory.emplace();
    CHECK(kept() == Names{"yield_stress", "friction_coefficient"});
}

TEST_CASE("Particles enter with the values of the friction law", "[history]") {
    FrictionLaw law;
    law.mu = {0.3, 0.4};
    const auto& [pressure, traction_x, traction_y, yield_stress, friction_coefficient] = history_arrays;
    CHECK((pressure.is_traction() && traction_x.is_traction() && traction_y.is_traction()));
    CHECK_FALSE(yield_stress.entering(law, 1));
    law.layer = InterfacialLayer{1e-5, 120, 10};
    CHECK(yield_stress.entering(law, 1) == 120);
    CHECK(friction_coefficient.entering(law, 1) == 0.4);
}

TEST_CASE("Arrays of a solution are in the order of their names", "[history]") {
    const auto at = [](SolutionField field) { return solution_arrays[static_cast<std::size_t>(field)]; };
    CHECK(at(SolutionField::element_division) == nullptr);
    CHECK(at(SolutionField::slip_y) == &ContactSolution::slip_y);
    CHECK(at(SolutionField::lower_temperature) == &ContactSolution::lower_temperature);
    CHECK(solution_arrays.size() == enum_words<SolutionField>.size());
    CHECK(all_solution_fields.size() == enum_words<SolutionField>.size());
}

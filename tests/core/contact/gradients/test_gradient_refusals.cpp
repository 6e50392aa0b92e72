#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

#include "contactd/error.hpp"
#include "gradient_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

void check_refused(const ContactProblem& problem, const std::string& message,
                   const Cotangents& output = output_of(&Cotangents::Fn), const std::vector<GradientInput>& by = {}) {
    CHECK_THROWS_MATCHES(validate_gradients(problem, {output}, by), InvalidArgument,
                         MessageMatches(ContainsSubstring(message)));
}

}  // namespace

TEST_CASE("problems without gradients are refused by name", "[gradients]") {
    const ContactProblem problem = rolling_steel();
    CHECK_NOTHROW(validate_gradients(problem, {output_of(&Cotangents::Fx)}, all_of_a_step));
    ContactProblem other = problem;
    other.model = Model::fastsim;
    check_refused(other, "vjp is not available for simplified models; use model full");
    other = problem;
    other.normal_model = NormalModel::kp;
    check_refused(other, "remove normal_model");
    other = problem;
    other.columns = ContactColumns{};
    check_refused(other, "on curved columns");
    other = problem;
    other.bodies.lower.viscoelastic = Viscoelasticity{1, 0.1};
    check_refused(other, "viscoelastic");
    other = problem;
    other.friction->layer = InterfacialLayer{.flexibility = 1e-5, .yield_stress = 10};
    check_refused(other, "remove friction.layer.yield_stress");
    other = problem;
    other.friction->kinetic = KineticFriction{};
    check_refused(other, "remove friction.kinetic");
    other = problem;
    other.friction->temperature = TemperatureFriction{};
    check_refused(other, "remove friction.temperature");
    other = problem;
    std::get<Rolling>(other.motion).kind = RollingKind::transient;
    std::get<Rolling>(other.motion).steps = 3;
    check_refused(other, "for 3 steps at once (friction.rolling.steps)");
}

TEST_CASE("inputs that a problem does not have are refused", "[gradients]") {
    const Cotangents Fn = output_of(&Cotangents::Fn);
    check_refused(rolling_steel(), "by contains previous", Fn, {GradientInput::previous});
    check_refused(pressed_patch(), "by contains mu", Fn, {GradientInput::mu});
    check_refused(pressed_patch(), "by contains rigid_slip", Fn, {GradientInput::rigid_slip});
    ContactProblem given = pressed_patch();
    given.bodies.pair = GivenIcs{pair_table(given), given.grid.dx, given.grid.dy};
    check_refused(given, "by contains materials", Fn, {GradientInput::materials});
}

TEST_CASE("outputs that a problem does not have are refused", "[gradients]") {
    const ContactProblem normal = pressed_patch(), shift = shifted_patch(), rolling = rolling_steel();
    check_refused(normal, "vjp[0].Fx is 1, but it requires friction", output_of(&Cotangents::Fx));
    check_refused(shift, "vjp[0].xi is 1, but it requires friction.rolling", output_of(&Cotangents::xi));
    check_refused(shift, "vjp[0].frictional_power", output_of(&Cotangents::frictional_power));
    check_refused(rolling, "vjp[0].frictional_work", output_of(&Cotangents::frictional_work));
    check_refused(rolling, "vjp[0].Fx is nan; it must be finite",
                  output_of(&Cotangents::Fx, std::numeric_limits<double>::quiet_NaN()));
    check_refused(rolling, "vjp[0].norm_order is 0.5; it must lie between 1 and 1000",
                  output_of(&Cotangents::norm_order, 0.5));
    Cotangents output;
    output.pressure = {1, 2};
    check_refused(rolling, "vjp[0].pressure has 2 values; the grid has 320 elements", output);
    output.pressure = Values(320, std::numeric_limits<double>::infinity());
    check_refused(rolling, "vjp[0].pressure contains inf; all values must be finite", output);
    output = {};
    output.loss_of_rows = {1};
    check_refused(rolling, "vjp[0].loss_of_rows has 1 values; the grid has 16 rows", output);
    output = {};
    output.traction_x = Values(256);
    check_refused(normal, "vjp[0].traction_x is given, but the problem has no friction", output);
    CHECK_THROWS_AS(validate_gradients(rolling, {}, {}), InvalidArgument);
    CHECK_THROWS_AS(validate_gradients(rolling, std::vector<Cotangents>(101), {}), InvalidArgument);
}

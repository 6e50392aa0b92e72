// Tests sequences of cases: histories, refusals, files, and quantities by CONTACT's names.
#include "run/case_run.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "answers/contact_solver.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "read/contact_file_cases.hpp"

using namespace contactd;
using namespace contactd::cases;
using namespace contactd::contact_file_cases;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct CoreSolver : ProblemSolver {
    SolveReply solve(const ContactProblem& problem) override { return {contact.solve(problem), {}}; }
    WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state,
                            WheelRailEstimates& estimates) override {
        Observer observer;
        return WheelRailContact(setup).solve(state, estimates, observer);
    }
    ContactSolver contact;
};

std::vector<ContactFileOutcome> run(ContactFileInput input) {
    CoreSolver solver;
    CaseRun cases(std::move(input));
    std::vector<ContactFileOutcome> outcomes;
    while (auto outcome = cases.next(solver, Observer{})) outcomes.push_back(std::move(*outcome));
    return outcomes;
}

std::vector<ContactFileOutcome> run(const std::string& text) {
    ContactFileInput input;
    input.text = text;
    return run(std::move(input));
}

enum class Rest { more, none };

/// Creates a ball with semi-axes of 1 mm under 1000 N, shifted by `shift` (mm); the file may have more cases.
std::string ball(const std::string& digits, const std::string& shift, Rest rest = Rest::more) {
    BasicCase text;
    text.module = "";
    text.digits = digits + " P-B-T-N-F-S\n022020 L-D-C-M-Z-E\n00000" + std::string(rest == Rest::more ? "0" : "1") +
                  " H-G-I-A-O-W-R\n";
    text.load = "1000. " + shift + " 0. 0.\n";
    text.grid = "-3\n30 30 1. 1. 1.2\n";
    text.gap = "";
    return text.text();
}

const std::string module_3 = "3 MODULE\n";

}  // namespace

TEST_CASE("a Hertz case has its force and Hertz's largest pressure", "[contact_files]") {
    const auto outcomes = run(module_3 + ball("201100", "0.001", Rest::none) + end);
    REQUIRE(outcomes.size() == 1);
    const ContactFileOutcome& outcome = outcomes[0];
    CHECK(outcome.status == ContactFileStatus::solved);
    CHECK(outcome.sentence.empty());
    CHECK_THAT(outcome.numbers.at("FN"), WithinRel(1000, 1e-9));
    CHECK_THAT(outcome.numbers.at("PMAX"), WithinRel(1.5 * 1000 / std::numbers::pi, 0.01));
    CHECK(outcome.numbers.at("NCON") == outcome.numbers.at("NADH") + outcome.numbers.at("NSLIP"));
    const ContactFilePatch& patch = outcome.patches.at(0);
    CHECK_THAT(patch.friction_bound, WithinRel(300, 1e-9));
    double sum = 0;
    for (const double p : patch.arrays.at("PN")) sum += p * patch.grid.element_area();
    CHECK_THAT(sum, WithinRel(1000, 1e-9));
}

TEST_CASE("two shifts one after the other are one shift of their sum, and a repeated one counts once",
          "[contact_files]") {
    const auto halves = run(module_3 + ball("201100", "0.0005") + ball("001100", "0.0005") +
                            ball("301100", "0.0005", Rest::none) + end);
    const auto whole = run(module_3 + ball("201100", "0.001", Rest::none) + end);
    REQUIRE(halves.size() == 3);
    const double force = whole[0].numbers.at("FX");
    CHECK(std::abs(force) > 50);
    CHECK_THAT(halves[1].numbers.at("FX"), WithinRel(force, 5e-3));
    CHECK_THAT(halves[2].numbers.at("FX"), WithinRel(halves[1].numbers.at("FX"), 1e-6));
    CHECK(std::abs(halves[0].numbers.at("FX")) < std::abs(force));
}

TEST_CASE("a case that is wrong has the reason, and so have those that continue it", "[contact_files]") {
    BasicCase wrong;
    wrong.module = "";
    wrong.digits = "201100\n022020\n0000000\n";
    wrong.material = ".7 .28 82000. 82000.\n";
    const auto outcomes = run(module_3 + wrong.text() + ball("001100", "0.001") + ball("201100", "0.001") +
                              ball("001100", "0.001", Rest::none) + end);
    REQUIRE(outcomes.size() == 4);
    CHECK(outcomes[0].status == ContactFileStatus::wrong);
    CHECK(outcomes[0].sentence == "POISS1 is 0.7; it must be from 0 to 0.5.");
    CHECK(outcomes[1].status == ContactFileStatus::follows);
    CHECK_THAT(outcomes[1].sentence, ContainsSubstring("case 1 in line 2"));
    CHECK(outcomes[2].status == ContactFileStatus::solved);
    CHECK(outcomes[3].status == ContactFileStatus::solved);
}

TEST_CASE("only requested cases are computed, and none that continues another one", "[contact_files]") {
    ContactFileInput input;
    input.text =
        module_3 + ball("201100", "0.001") + ball("001100", "0.001") + ball("201100", "0.002", Rest::none) + end;
    input.cases = {1, 2};
    const auto outcomes = run(std::move(input));
    REQUIRE(outcomes.size() == 2);
    CHECK(outcomes[0].number == 2);
    CHECK(outcomes[0].status == ContactFileStatus::follows);
    CHECK_THAT(outcomes[0].sentence, ContainsSubstring("not requested"));
    CHECK(outcomes[1].status == ContactFileStatus::solved);
}

TEST_CASE("a rolling direction across x is warned of where it has no effect", "[contact_files]") {
    const auto rolled = [](const std::string& digits, const std::string& chi) {
        BasicCase text;
        text.digits = "203100\n" + digits + "\n000001\n";
        text.rolling = chi + " 1. 10000.\n";
        if (digits[3] == '3') text.more = "1e-5 1e-5 1e-5\n";
        const auto outcomes = run(text.text() + end);
        const auto& warnings = outcomes.at(0).warnings;
        return std::ranges::count_if(warnings,
                                     [](const std::string& one) { return one.find("CHI = ") != std::string::npos; });
    };
    CHECK(rolled("022020", "0.") == 0);
    CHECK(rolled("022020", "90d") == 1);
    CHECK(rolled("022020", "180d") == 0);
    CHECK(rolled("022320", "90d") == 1);
}

TEST_CASE("large cases are refused before memory is allocated", "[contact_files]") {
    ContactFileInput input;
    BasicCase large;
    large.grid = "1\n40000 40000 -1. -.75 .5 .5\n";
    input.text = large.text() + end;
    const auto outcomes = run(std::move(input));
    REQUIRE(outcomes.size() == 1);
    CHECK(outcomes[0].status == ContactFileStatus::refused);
    CHECK_THAT(outcomes[0].sentence, ContainsSubstring("1600000000 elements; at most 40000"));
}

TEST_CASE("the points of a case are bounded by its elements", "[contact_files]") {
    const auto layers = [](int count) {
        ContactFileInput input;
        input.text = module_3 + ball("201103", "0.001", Rest::none) + "2 1 A, O\n1 ISUBS\n" + std::to_string(count) +
                     " 0.1 0.1\n0\n" + end;
        input.max_elements = 900;
        return run(std::move(input));
    };
    const auto possible = layers(10), refused = layers(11);
    CHECK(possible.at(0).status == ContactFileStatus::solved);
    CHECK(possible[0].patches.at(0).blocks.at(0).points.size() == 9000);
    CHECK(refused.at(0).status == ContactFileStatus::refused);
    CHECK_THAT(refused[0].sentence, ContainsSubstring("9900 subsurface points") && ContainsSubstring("max_elements"));
}

TEST_CASE("a case names the file that it lacks", "[contact_files]") {
    ContactFileInput input;
    input.text = RailCase{}.text() + end;
    SECTION("that was not given") {
        const auto outcomes = run(std::move(input));
        CHECK(outcomes.at(0).status == ContactFileStatus::wrong);
        CHECK(outcomes[0].sentence == "The file \"rail.prr\" cannot be read: its content was not given.");
    }
    SECTION("that could not be read") {
        input.files = {{"rail.prr", "", "Permission denied"}};
        const auto outcomes = run(std::move(input));
        CHECK(outcomes.at(0).status == ContactFileStatus::wrong);
        CHECK_THAT(outcomes[0].sentence, ContainsSubstring("Permission denied"));
    }
}

namespace {

/// Creates a cylindrical rail and a cone of 1/20, as points of y and z (mm).
ContactFileInput wheel_on_rail(const std::string& configuration, double y) {
    std::string rail, wheel;
    for (int i = -30; i <= 30; ++i)
        rail += std::to_string(i) + " " + std::to_string(300 - std::sqrt(300.0 * 300 - i * i)) + "\n";
    for (int i = -60; i <= 60; ++i) wheel += std::to_string(i) + " " + std::to_string(-i / 20.0) + "\n";
    RailCase text;
    text.digits = configuration + "203100 C-P-B-T-N-F-S\n0022033 V-L-D-C-M-Z-E\n0000001 H-G-I-A-O-W-R\n";
    text.track = configuration == "1" ? "-1. 750. 0. 0.\n" : "-1. -750. 0. 0.\n";
    text.rail = "'rail.txt' 0 1. 0.\n";
    text.deviation = "0. 0. 0. 0. 0. 0.\n";
    text.wheel = "'folder/wheel.txt' 0 1. 0.\n";
    text.position = "0. " + std::to_string(y) + " 10000. 0. 0. 0.\n";
    ContactFileInput input;
    input.text = text.text() + end;
    input.files = {{"rail.txt", rail}, {"folder/wheel.txt", wheel}};
    return input;
}

}  // namespace

TEST_CASE("a wheel on its rail has its force, and the left one is its mirror image", "[contact_files]") {
    const auto right = run(wheel_on_rail("1", 1.5)), left = run(wheel_on_rail("0", -1.5));
    REQUIRE(right.at(0).status == ContactFileStatus::solved);
    REQUIRE(left.at(0).status == ContactFileStatus::solved);
    CHECK_THAT(right[0].numbers.at("FZ(TR)"), WithinRel(10000, 1e-5));
    CHECK_THAT(left[0].numbers.at("FZ(TR)"), WithinRel(right[0].numbers.at("FZ(TR)"), 1e-9));
    CHECK_THAT(left[0].numbers.at("FX(TR)"), WithinRel(right[0].numbers.at("FX(TR)"), 1e-6));
    CHECK_THAT(left[0].numbers.at("FY(TR)"), WithinRel(-right[0].numbers.at("FY(TR)"), 1e-6));
    const auto &one = right[0].patches.at(0).numbers, &other = left[0].patches.at(0).numbers;
    for (const char* name : {"XCP(TR)", "ZCP(TR)", "FN", "FX", "APPROACH", "PMAX", "NCON", "ZCP(R)", "ZCP(W)"})
        CHECK_THAT(other.at(name), WithinAbs(one.at(name), 1e-6 * (1 + std::abs(one.at(name)))));
    for (const char* name : {"YCP(TR)", "DELTCP(TR)", "FS", "YCP(R)", "YCP(W)", "CPHI"})
        CHECK_THAT(other.at(name), WithinAbs(-one.at(name), 1e-6 * (1 + std::abs(one.at(name)))));
}

TEST_CASE("a patch on rails has larger elements than a run accepts, and says so", "[contact_files]") {
    ContactFileInput input = wheel_on_rail("1", 0);
    input.max_elements = 100;
    const auto outcomes = run(std::move(input));
    REQUIRE(outcomes.at(0).patches.size() == 1);
    CHECK(outcomes[0].patches[0].grid.size() <= 100);
    bool warned = false;
    for (const std::string& warning : outcomes[0].warnings) warned = warned || warning.find("100") != std::string::npos;
    CHECK(warned);
}

TEST_CASE("a wheel under a force that touches nothing has no solution", "[contact_files]") {
    const auto beside = run(wheel_on_rail("1", 200));
    CHECK(beside.at(0).status == ContactFileStatus::not_converged);
    CHECK(beside[0].patches.empty());
    CHECK_THAT(beside[0].sentence, ContainsSubstring("no contact"));
}

TEST_CASE("a converted case is the problem that a run solves", "[contact_files]") {
    ContactFileInput input;
    input.text = module_3 + ball("201100", "0.001") + ball("001100", "0.001", Rest::none) + end;
    CoreSolver solver;
    CaseRun conversion(input);
    const auto first = conversion.convert_next(solver, Observer{}),
               second = conversion.convert_next(solver, Observer{});
    REQUIRE(first);
    REQUIRE(second);
    CHECK_FALSE(conversion.convert_next(solver, Observer{}));
    CHECK_FALSE(first->continues);
    CHECK(second->continues);
    const auto& problem = std::get<ContactProblem>(first->problem);
    const ContactSolution solution = solver.contact.solve(problem);
    const auto outcomes = run(std::move(input));
    CHECK(solution.forces.Fx == std::get<SolveReply>(outcomes.at(0).solution).solution.forces.Fx);
}

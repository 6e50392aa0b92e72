// Runs random contact problems with layers and with friction that has memory: random_state [count] [first seed]
// [largest size]. Prints those that did not converge and those whose solution violates the equations; the status is 1
// when any does.
#include "contact/friction/random_state.hpp"

#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

namespace {

void describe(int seed, const ContactProblem& problem) {
    const FrictionLaw& friction = *problem.friction;
    const InterfacialLayer layer = friction.layer.value_or(InterfacialLayer{});
    const bool shifts = std::holds_alternative<Shift>(problem.motion);
    std::printf("seed %d, %d x %d, %s%s%s%s%s%s: ", seed, problem.grid.nx, problem.grid.ny,
                shifts               ? "shift"
                : is_steady(problem) ? "steady rolling"
                                     : "transient rolling",
                problem.bodies.materials().quasi_identical() ? "" : ", dissimilar", friction.layer ? ", layer" : "",
                layer.hardens() ? layer.hardening > 0 ? ", hardens" : ", softens" : "",
                layer.yields() && !layer.hardens() ? ", flows" : "", friction.kinetic ? ", memory" : "");
}

}  // namespace

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 2000), first = argument(2, 1), largest_size = argument(3, 32);
    int solved = 0, unconverged = 0, wrong = 0;
    for (int seed = first; seed < first + count; ++seed) {
        const auto problem = random_state(static_cast<std::uint64_t>(seed), largest_size);
        if (!problem) continue;
        ++solved;
        const ContactSolution solution = solve_half_spaces(*problem);
        if (!solution.converged()) {
            ++unconverged;
            describe(seed, *problem);
            std::printf("not converged:");
            for (const auto& evidence :
                 {solution.evidence.tangential, solution.evidence.outer, solution.evidence.force})
                if (evidence && !evidence->converged) std::printf(" %d %.1e", evidence->iterations, evidence->residual);
            std::printf("\n");
            continue;
        }
        const std::string faults = state_faults(*problem, solution, 1e-4);
        if (faults.empty()) continue;
        ++wrong;
        describe(seed, *problem);
        std::printf("%s\n", faults.c_str());
    }
    std::printf("%d problems: %d not converged, %d wrong\n", solved, unconverged, wrong);
    return wrong == 0 ? 0 : 1;
}

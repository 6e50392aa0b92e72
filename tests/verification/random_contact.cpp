// Runs random contact problems of every kind: random_contact [count] [first seed] [largest size]. Prints those that did
// not converge and those whose solution violates the contact conditions; the status is 1 when any does. Counts those
// whose tractions TangCG has found, because Newton's method stopped, and those of them under prescribed forces.
#include "contact/random_contact.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

namespace {

const char* kind_of(const ContactProblem& problem) {
    if (!problem.friction) return "normal";
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return rolling == nullptr ? "shift" : rolling->steady() ? "steady rolling" : "transient rolling";
}

}  // namespace

int main(int argc, char** argv) {
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 2000), first = argument(2, 1), largest_size = argument(3, 64);
    int unconverged = 0, wrong = 0, by_tangcg = 0, forces_by_tangcg = 0;
    double longest = 0;
    for (int seed = first; seed < first + count; ++seed) {
        const ContactProblem problem = random_contact(static_cast<std::uint64_t>(seed), largest_size);
        const auto start = std::chrono::steady_clock::now();
        const ContactSolution solution = solve_half_spaces(problem);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        longest = std::max(longest, seconds.count());
        if (solution.evidence.tangential_solver == TangentialSolver::tangcg) {
            ++by_tangcg;
            if (solution.evidence.force) ++forces_by_tangcg;
        }
        const auto describe = [&] {
            std::printf("seed %d, %d x %d, %s%s%s: ", seed, problem.grid.nx, problem.grid.ny, kind_of(problem),
                        problem.bodies.materials().quasi_identical() ? "" : ", dissimilar",
                        problem.friction && problem.friction->kinetic ? ", slip law" : "");
        };
        if (!solution.converged()) {
            ++unconverged;
            describe();
            print_unconverged(solution);
            continue;
        }
        const std::string faults = contact_faults(problem, solution, state_before_last(problem), 1e-4);
        if (faults.empty()) continue;
        ++wrong;
        describe();
        std::printf("%s\n", faults.c_str());
    }
    std::printf("%d problems: %d not converged, %d wrong, longest solve %.2f s\n", count, unconverged, wrong, longest);
    std::printf("tractions by TangCG: %d, under forces %d\n", by_tangcg, forces_by_tangcg);
    return wrong == 0 ? 0 : 1;
}

// Runs random normal contact problems of up to 64 x 64 elements, with prescribed approach or force, and checks them
//     independently of the solver. random_normal [COUNT [FIRST SEED]] 2000 problems by default Lists every problem that
//     is wrong or did not converge; ends with 1 when one is wrong or more than 0.5 % did not.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "contact/normal/normal.hpp"
#include "contact/random_problems.hpp"
#include "operators/convolution.hpp"

int main(int count_of_arguments, char** arguments) {
    using namespace contactd;
    using namespace contactd::test;
    const auto argument = [&](int index, unsigned long long otherwise) {
        return count_of_arguments > index ? std::strtoull(arguments[index], nullptr, 10) : otherwise;
    };
    const unsigned long long count = argument(1, 2000), first = argument(2, 1);
    const SolverSettings settings;
    Observer observer;
    unsigned long long wrong = 0, unconverged = 0;
    long iterations = 0;
    for (unsigned long long seed = first; seed < first + count; ++seed) {
        const RandomNormal problem = random_normal(seed, 64);
        const ConvolutionOperator influence(problem.table, problem.grid.nx, problem.grid.ny);
        NormalSolution solution;
        if (problem.pressure_sum) {
            solution = solve_normal_force(influence, problem.distance, *problem.pressure_sum, settings, {}, observer);
        } else {
            Values gap = problem.distance;
            for (double& h : gap) h -= problem.approach;
            solution = solve_normal(influence, gap, settings, {}, observer);
            solution.approach = problem.approach;
        }
        iterations += solution.evidence.iterations;
        std::string fault = normal_faults(problem, solution.pressure, solution.approach, settings.tolerance);
        if (!solution.evidence.converged) {
            ++unconverged;
            fault = "not converged";
        } else if (!fault.empty()) {
            ++wrong;
        }
        if (!fault.empty())
            std::printf("seed %llu, %d x %d elements, %s prescribed: %s\n", seed, problem.grid.nx, problem.grid.ny,
                        problem.pressure_sum ? "force" : "approach", fault.c_str());
    }
    std::printf("%llu problems: %llu wrong, %llu not converged, %.1f iterations on average\n", count, wrong,
                unconverged, static_cast<double>(iterations) / static_cast<double>(count));
    return wrong > 0 || 200 * unconverged > count;
}

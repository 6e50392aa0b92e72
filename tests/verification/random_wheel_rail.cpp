// Runs random positions of wheels on rails, with exact and measured profiles. random_wheel_rail [COUNT [FIRST SEED]]
//     1000 positions by default, ten of each set-up Lists every answer that is wrong, counts the sentences of the
//     others, and ends with 1 when one is wrong or took more than ten seconds of a processor.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <string_view>

#include "contactd/error.hpp"
#include "wheel_rail/random_wheel_rail.hpp"

namespace {

/// A warning or an error without its numbers.
std::string kind_of(const std::string& sentence) {
    std::string kind;
    for (const char c : sentence)
        if (std::string_view("0123456789.-").find(c) == std::string_view::npos) kind += c;
    return kind.substr(0, 90);
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
    using namespace contactd;
    using namespace contactd::test;
    const auto argument = [&](int index, unsigned long long otherwise) {
        return count_of_arguments > index ? std::strtoull(arguments[index], nullptr, 10) : otherwise;
    };
    const unsigned long long count = argument(1, 1000), first = argument(2, 1);
    constexpr unsigned long long states_of_each = 10;
    std::map<std::string, int> counts;
    unsigned long long wrong = 0, slow = 0;
    double slowest = 0;
    Observer observer;
    for (unsigned long long seed = first; seed < first + count / states_of_each; ++seed) {
        Dice dice(seed);
        RandomWheelRail problem{random_setup(dice, 0.5), {}};
        try {
            const WheelRailContact contact(problem.setup);
            for (unsigned long long i = 0; i < states_of_each; ++i) {
                const std::clock_t begin = std::clock();
                std::string fault;
                try {
                    problem.state = random_state(dice, contact);
                    const WheelRailSolution solution = contact.solve(problem.state, observer);
                    fault = wheel_rail_faults(problem, solution);
                    ++counts[solution.patches.empty() ? "no contact"
                             : solution.converged()   ? "solved"
                                                      : "not converged"];
                    for (const std::string& warning : solution.warnings) ++counts["  warning: " + kind_of(warning)];
                } catch (const InvalidArgument& error) {
                    ++counts["refused: " + kind_of(error.what())];
                }
                const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
                if (seconds > slowest) slowest = seconds;
                if (seconds > 10) ++slow;
                if (!fault.empty()) ++wrong;
                if (!fault.empty() || seconds > 10)
                    std::printf("seed %llu, state %llu, %.1f s: %s\n", seed, i, seconds, fault.c_str());
            }
        } catch (const InvalidArgument& error) {
            ++counts["set-up refused: " + kind_of(error.what())];
        }
    }
    for (const auto& [what, times] : counts) std::printf("%6d %s\n", times, what.c_str());
    std::printf("%llu wrong, %llu slow, the slowest took %.2f s\n", wrong, slow, slowest);
    return wrong > 0 || slow > 0;
}

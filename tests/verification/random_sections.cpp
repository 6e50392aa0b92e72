// Runs contacts of random cross-sections: random_sections [count] [first seed]. Prints those that did not converge, or
// whose solution violates the contact conditions, and why sections were refused; the status is 1 when any is wrong.
#include "fem/section/random_sections.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace contactd;
using namespace contactd::test;

int main(int argc, char** argv) {
    const fem::Runtime runtime(argc, argv);
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    const int count = argument(1, 500), first = argument(2, 1);
    int refused = 0, wrong = 0;
    double longest = 0;
    for (int seed = first; seed < first + count; ++seed) {
        const auto start = std::chrono::steady_clock::now();
        std::string fault;
        try {
            const SectionContact contact = random_section_contact(static_cast<std::uint64_t>(seed));
            if (!contact.refused.empty()) {
                ++refused;
                std::printf("seed %d is refused: %s\n", seed, contact.refused.c_str());
                continue;
            }
            fault = section_faults(contact, solve(contact));
        } catch (const std::exception& error) {
            fault = error.what();
        }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        longest = std::max(longest, seconds.count());
        if (fault.empty()) continue;
        ++wrong;
        std::printf("seed %d: %s\n", seed, fault.c_str());
        std::fflush(stdout);
    }
    std::printf("%d sections: %d refused, %d wrong or not converged, longest %.2f s\n", count, refused, wrong, longest);
    return wrong == 0 ? 0 : 1;
}

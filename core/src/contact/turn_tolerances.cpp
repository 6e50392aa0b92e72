#include "turn_tolerances.hpp"

#include <algorithm>

namespace contactd {
namespace {

constexpr double first_normal = 1e-3, first_tangential = 5e-2;
constexpr double normal_part = 0.005, tangential_part = 0.06;  // of the expected change
constexpr double least_rate = 0.03, largest_rate = 0.3, first_rate = 0.05;

void tighten(SolverSettings& settings, double tolerance, const SolverSettings& last) {
    settings.tolerance = std::clamp(tolerance, last.tolerance, std::max(settings.tolerance, last.tolerance));
}

}  // namespace

TurnTolerances::TurnTolerances(const ContactSetup& setup, bool loose)
    : setup_(setup), normal_(setup.settings.normal), tangential_(setup.settings.tangential) {
    if (!loose) return;
    normal_.tolerance = std::max(normal_.tolerance, first_normal);
    tangential_.tolerance = std::max(tangential_.tolerance, first_tangential);
}

bool TurnTolerances::are_final() const {
    return normal_ == setup_.settings.normal && tangential_ == setup_.settings.tangential;
}

void TurnTolerances::follow(double change) {
    const double rate =
        last_change_ && *last_change_ > 0 ? std::clamp(change / *last_change_, least_rate, largest_rate) : first_rate;
    last_change_ = change;
    const double expected = rate * change;
    const bool is_last = expected <= setup_.settings.outer.tolerance;
    tighten(normal_, is_last ? 0 : normal_part * expected, setup_.settings.normal);
    tighten(tangential_, is_last ? 0 : tangential_part * expected, setup_.settings.tangential);
}

}  // namespace contactd

#include "outer_tolerances.hpp"

#include <algorithm>

namespace contactd {
namespace {

constexpr double first_normal = 3e-3, first_tangential = 0.1;
constexpr double normal_part = 0.01, tangential_part = 0.2;  // fraction of the expected change
constexpr double least_rate = 0.03, largest_rate = 0.3, first_rate = 0.05;
// Rates in this range allow an estimate of the remaining change. Smaller ones may be chance, and larger ones do not
// indicate a convergent series. The smaller one of the last two counts, because the next iteration also corrects what
// one left unsolved, which adds to its change.
constexpr double least_sure_rate = 0.1, largest_sure_rate = 0.5;

void tighten(SolverSettings& settings, double tolerance, const SolverSettings& last) {
    settings.tolerance = std::clamp(tolerance, last.tolerance, std::max(settings.tolerance, last.tolerance));
}

// Returns the sum of a geometric series after `change`.
double sum_behind(double change, double rate) {
    rate = std::max(rate, least_sure_rate);
    return rate <= largest_sure_rate ? change * rate / (1 - rate) : change;
}

}  // namespace

OuterTolerances::OuterTolerances(const ContactSetup& setup, bool loose)
    : setup_(setup), loose_(loose), normal_(setup.settings.normal), tangential_(setup.settings.tangential) {
    if (!loose || next_is_last_allowed()) return;
    normal_.tolerance = std::max(normal_.tolerance, first_normal);
    tangential_.tolerance = std::max(tangential_.tolerance, first_tangential);
}

bool OuterTolerances::are_final() const {
    return normal_ == setup_.settings.normal && tangential_ == setup_.settings.tangential;
}

bool OuterTolerances::next_is_last_allowed() const {
    return iterations_ + 1 >= setup_.settings.outer.max_iterations;
}

void OuterTolerances::follow(double change) {
    const bool is_first = change_ == 0;
    ++iterations_;
    const double last = is_first ? 1 : change / change_;
    sure_rate_ = std::min(rate_, last);
    rate_ = last;
    change_ = change;
    const double next = change * (is_first ? first_rate : std::clamp(rate_, least_rate, largest_rate));
    const double after_next = is_first ? next : sum_behind(next, sure_rate_);
    const bool settles = after_next <= setup_.settings.outer.tolerance, is_last = settles || next_is_last_allowed();
    was_forced_ = is_forced_;
    is_forced_ = is_last && !settles && !are_final();
    tighten(normal_, is_last ? 0 : normal_part * next, setup_.settings.normal);
    tighten(tangential_, is_last ? 0 : tangential_part * next, setup_.settings.tangential);
}

double OuterTolerances::left() const {
    return loose_ && !was_forced_ ? sum_behind(change_, sure_rate_) : change_;
}

}  // namespace contactd

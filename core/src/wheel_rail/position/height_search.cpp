#include "height_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace contactd {
namespace {

/// Raises the force to the inverse power of Hertz's law, which is nearly linear in z.
double straightened(double force) {
    return std::cbrt(force * force);
}

/// Holds the logarithm of the ratio of forces to their estimates, as a straight line through the known values.
class Correction {
   public:
    explicit Correction(HeightCorrection expected) : line_(expected) {}

    void learn(double z, double logarithm) {
        if (z_ && std::abs(z - *z_) > least_distance) line_.slope = (logarithm - line_.logarithm) / (z - *z_);
        line_.logarithm = logarithm;
        z_ = z;
    }
    /// Drops the slope from two heights beyond a decrease, which does not apply here.
    void forget_slope() { line_.slope = 0; }
    double at(double z) const { return line_.logarithm + (z_ ? std::clamp(line_.slope * (z - *z_), -1.0, 1.0) : 0); }
    HeightCorrection line_at(double z) const { return {at(z), line_.slope}; }

   private:
    // At smaller distances (mm), friction causes the difference of forces, not the height.
    static constexpr double least_distance = 1e-5;
    HeightCorrection line_;
    std::optional<double> z_;  // height of its logarithm
};

class Search {
   public:
    explicit Search(const HeightTask& task)
        : task_(task),
          least_(task.shallowest.value_or(task.first_contact_height)),
          low_(least_),
          high_(task.deepest),
          settled_(tight()),
          correction_(task.correction) {}

    HeightFound run() {
        HeightFound found{task_.first_contact_height, {0, std::numeric_limits<double>::infinity(), false, 0}};
        double z = next();
        for (int solve = 1; solve <= task_.settings.max_iterations; ++solve) {
            const double force = task_.force(z), expected = estimate(z), target = target_force(z);
            if (force > 0 && expected > 0) correction_.learn(z, std::log(force / expected));
            found = {z, {solve, std::abs(force - target) / target, false, 0}, correction_.line_at(z)};
            found.evidence.converged = found.evidence.residual <= task_.settings.tolerance;
            solved_.push_back({z, force - target, force});
            found.falls = falls_ = falls_ || falls_behind_last();
            if (found.evidence.converged) break;
            // The estimate, corrected once, is useless: this force is not plausible for these bodies.
            if (solve > 1 && force > runaway * target) break;
            (force < target ? low_ : high_) = z;
            if (high_ - low_ < 1e-12 * (1 + std::abs(high_))) break;
            settled_ = std::max(tight(), loose * found.evidence.residual);
            const double last = z;
            const auto beside = hidden();
            z = beside ? *beside : by_forces().value_or(force > 0 && expected > 0 ? next() : 0.5 * (low_ + high_));
            if (z == last) break;
        }
        if (!found.evidence.converged) found.jump = jump();
        return found;
    }

   private:
    struct End {
        double z, excess;
    };
    struct Solved {
        double z, excess, force;
    };

    bool falls_behind_last() const {
        const Solved& last = solved_.back();
        return std::ranges::any_of(solved_, [&](const Solved& other) {
            const Solved &upper = other.z < last.z ? other : last, &lower = other.z < last.z ? last : other;
            return lower.force < upper.force * (1 - noise);
        });
    }

    /// Returns a height beside the first one if the force has moved away from its target although the wheel was moved
    /// towards it. A height nearer to the first one may exist on either side of it. It returns only a few.
    std::optional<double> hidden() {
        const Solved first = solved_.front(), last = solved_.back();
        const bool lacks = first.excess < 0;
        if (probed_ == 0) {
            const bool goes_away = lacks ? last.z > first.z && last.force < first.force * (1 - noise)
                                         : last.z < first.z && last.force > first.force * (1 + noise);
            if (!goes_away) return std::nullopt;
            far_ = last.z;
        } else if (probed_ > probes.size()) {
            return std::nullopt;
        } else if (last.excess * first.excess < 0) {
            // There are now bounds beside the first height: it and this one, or this one and a height without contact.
            const bool behind = (last.z < first.z) == lacks;
            low_ = lacks ? (behind ? least_ : first.z) : last.z;
            high_ = lacks ? last.z : (behind ? task_.deepest : first.z);
            probed_ = probes.size() + 1;
            correction_.forget_slope();
            return std::nullopt;
        }
        if (probed_ == probes.size()) {
            ++probed_;
            low_ = lacks ? far_ : least_;
            high_ = lacks ? task_.deepest : far_;
            return std::nullopt;
        }
        low_ = least_;
        high_ = task_.deepest;
        return std::clamp(first.z + (far_ - first.z) * probes[probed_++], least_, task_.deepest);
    }

    std::optional<HeightFound::Jump> jump() const {
        constexpr double close = 1e-6;  // mm
        const auto low = std::ranges::find(solved_, low_, &Solved::z),
                   high = std::ranges::find(solved_, high_, &Solved::z);
        if (low == solved_.end() || high == solved_.end() || !(high_ - low_ < close)) return std::nullopt;
        return HeightFound::Jump{low->force, high->force};
    }

    /// Applies regula falsi between forces (Illinois), if estimates have not converged in a few solves, as for patches
    /// that merge.
    std::optional<double> by_forces() {
        constexpr std::size_t enough = 20;
        const std::size_t count = solved_.size();
        if (count < enough) return std::nullopt;
        const auto at = [&](double z) { return std::ranges::find(solved_, z, &Solved::z); };
        const auto low = at(low_), high = at(high_);
        if (low == solved_.end() || high == solved_.end()) return std::nullopt;
        same_side_ = solved_[count - 1].excess * solved_[count - 2].excess > 0 ? same_side_ + 1 : 0;
        const double old = std::ldexp(1, -same_side_);  // weight of the end that stays
        const bool is_low = solved_.back().z == low_;
        const double below = (is_low ? 1 : old) * low->excess, above = (is_low ? old : 1) * high->excess;
        const double z = (low_ * above - high_ * below) / (above - below);
        return z > low_ && z < high_ ? z : std::midpoint(low_, high_);
    }

    double estimate(double z) {
        const auto [known, is_new] = estimates_.try_emplace(z, 0);
        if (is_new) known->second = task_.estimate(z);
        return known->second;
    }

    /// Returns the target force at z; a spring that is nearly unloaded counts as one with a small load.
    double target_force(double z) const {
        return std::max(task_.target - task_.spring * (z - task_.first_contact_height), 1e-9 * task_.target);
    }
    /// Returns the excess of the corrected estimate over the target force. The force of a spring may be nearly zero.
    double excess(double z, double estimate) const {
        const double force = straightened(estimate * std::exp(correction_.at(z))),
                     target = straightened(target_force(z));
        return task_.spring == 0 ? force / target - 1 : 2 * (force - target) / (force + target);
    }
    double excess(double z) { return excess(z, estimate(z)); }

    // Returns the height where the corrected estimate has the target force, within the bounds by the forces.
    double next() {
        End low{low_, excess(low_)};
        if (low.excess >= 0) return std::midpoint(low_, std::min(high_, low_ + first_step));
        std::optional<End> high;
        for (auto known = estimates_.upper_bound(low_); !high && known != estimates_.end() && known->first <= high_;
             ++known) {
            const End here{known->first, excess(known->first, known->second)};
            if (here.excess < 0)
                low = here;
            else
                high = here;
        }
        while (!high) {
            if (low.z >= high_) return std::midpoint(low_, high_);
            const End further = beyond(low);
            if (further.excess < 0)
                low = further;
            else
                high = further;
        }
        return between(low, *high);
    }

    /// The excess is nearly linear from where it is -1. The result is slightly beyond the extrapolated height, because
    /// larger depths make the estimate more expensive.
    End beyond(const End& low) {
        constexpr double generous = 1.1;
        const double straight =
            low.excess > -1 ? -low.excess * (low.z - task_.first_contact_height) / (1 + low.excess) : first_step;
        const double z = std::min(low.z + std::max(generous * straight, 0.1 * first_step), high_);
        return {z, excess(z)};
    }

    /// Applies regula falsi between shrinking bounds (Illinois). The estimate only needs to increase.
    double between(End low, End high) {
        double z = std::midpoint(low.z, high.z);
        int side = 0;
        for (int iteration = 0; iteration < 60 && high.z - low.z > 1e-13 * (1 + std::abs(high.z)); ++iteration) {
            z = high.excess > low.excess ? (low.z * high.excess - high.z * low.excess) / (high.excess - low.excess)
                                         : std::midpoint(low.z, high.z);
            if (!(z > low.z && z < high.z)) z = std::midpoint(low.z, high.z);
            const End here{z, excess(z)};
            if (std::abs(here.excess) <= settled_) break;
            if (here.excess < 0) {
                low = here;
                if (side < 0) high.excess *= 0.5;
                side = -1;
            } else {
                high = here;
                if (side > 0) low.excess *= 0.5;
                side = 1;
            }
        }
        return z;
    }

    double tight() const { return 0.01 * task_.settings.tolerance; }

    static constexpr double first_step = 0.02;  // mm
    static constexpr double loose = 1e-3;       // fraction of the last error, which corrections do not reduce further
    static constexpr double runaway = 1e3;
    static constexpr double noise = 1e-3;  // noise of forces on other elements
    static constexpr std::array probes{-0.5, 0.25,  -1.0,
                                       0.5,  -0.25, -3.0};  // fractions of the way to where the force has moved away
    std::vector<Solved> solved_;
    bool falls_ = false;
    std::size_t probed_ = 0;
    int same_side_ = 0;
    double far_ = 0;
    const HeightTask& task_;
    double least_, low_, high_, settled_;
    std::map<double, double> estimates_;  // computed ones by z, because they are the same for each force
    Correction correction_;
};

}  // namespace

HeightFound find_height(const HeightTask& task) {
    return Search(task).run();
}

}  // namespace contactd

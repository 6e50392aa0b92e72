#include "height_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace contactd {
namespace {

/// The force to the power of Hertz's law, which is nearly straight in z.
double straightened(double force) {
    return std::cbrt(force * force);
}

/// By how much forces differ from their estimates: the logarithm of the ratio, a straight line through what is known.
class Correction {
   public:
    explicit Correction(HeightCorrection expected) : line_(expected) {}

    void learn(double z, double logarithm) {
        if (z_ && std::abs(z - *z_) > least_distance) line_.slope = (logarithm - line_.logarithm) / (z - *z_);
        line_.logarithm = logarithm;
        z_ = z;
    }
    double at(double z) const { return line_.logarithm + (z_ ? std::clamp(line_.slope * (z - *z_), -1.0, 1.0) : 0); }
    HeightCorrection line_at(double z) const { return {at(z), line_.slope}; }

   private:
    static constexpr double least_distance = 1e-5;  // mm: closer together friction tells forces apart, not the height
    HeightCorrection line_;
    std::optional<double> z_;  // where its logarithm is
};

class Search {
   public:
    explicit Search(const HeightTask& task)
        : task_(task),
          low_(task.first_contact_height),
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
            if (found.evidence.converged) break;
            // The estimate, corrected once, is no guide: these are no bodies that such a force presses together.
            if (solve > 1 && force > runaway * target) break;
            (force < target ? low_ : high_) = z;
            if (high_ - low_ < 1e-12 * (1 + std::abs(high_))) break;
            settled_ = std::max(tight(), loose * found.evidence.residual);
            const double last = z;
            z = force > 0 && expected > 0 ? next() : 0.5 * (low_ + high_);
            if (z == last) break;
        }
        return found;
    }

   private:
    struct End {
        double z, excess;
    };

    double estimate(double z) {
        const auto [known, is_new] = estimates_.try_emplace(z, 0);
        if (is_new) known->second = task_.estimate(z);
        return known->second;
    }

    /// The force at z; a spring that is nearly unloaded counts as one that carries a little.
    double target_force(double z) const {
        return std::max(task_.target - task_.spring * (z - task_.first_contact_height), 1e-9 * task_.target);
    }
    /// Returns the excess of the corrected estimate over the target force. The force of a spring may be next to
    /// nothing.
    double excess(double z, double estimate) const {
        const double force = straightened(estimate * std::exp(correction_.at(z))),
                     target = straightened(target_force(z));
        return task_.spring == 0 ? force / target - 1 : 2 * (force - target) / (force + target);
    }
    double excess(double z) { return excess(z, estimate(z)); }

    // Where the corrected estimate has the target force, within the bounds that the forces have given.
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

    /// The excess is nearly straight from where it is -1: a little further than where that leads, since what lies
    /// deeper costs the estimate more.
    End beyond(const End& low) {
        constexpr double generous = 1.1;
        const double straight =
            low.excess > -1 ? -low.excess * (low.z - task_.first_contact_height) / (1 + low.excess) : first_step;
        const double z = std::min(low.z + std::max(generous * straight, 0.1 * first_step), high_);
        return {z, excess(z)};
    }

    /// Regula falsi between bounds that close in (Illinois); nothing is asked of the estimate but that it rises.
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
    static constexpr double loose = 1e-3;       // of what was missing: corrections are not that good
    static constexpr double runaway = 1e3;
    const HeightTask& task_;
    double low_, high_, settled_;
    std::map<double, double> estimates_;  // those asked for, by z: from force to force they are the same
    Correction correction_;
};

}  // namespace

HeightFound find_height(const HeightTask& task) {
    return Search(task).run();
}

}  // namespace contactd

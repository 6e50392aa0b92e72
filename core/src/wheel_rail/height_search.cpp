#include "wheel_rail/height_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace contactd {
namespace {

/// The force to the power of Hertz's law, which is nearly straight in z.
double straightened(double force) {
    return std::cbrt(force * force);
}

/// Regula falsi between bounds that close in (Illinois), of a rising function of z; nothing is asked of it but that.
template <class Function>
double rising_root(const Function& function, double low, double high, double at_low, double at_high) {
    double z = 0.5 * (low + high);
    int side = 0;
    for (int iteration = 0; iteration < 60 && high - low > 1e-13 * (1 + std::abs(high)); ++iteration) {
        z = at_high > at_low ? (low * at_high - high * at_low) / (at_high - at_low) : 0.5 * (low + high);
        if (!(z > low && z < high)) z = 0.5 * (low + high);
        const double here = function(z);
        if (std::abs(here) <= 1e-10) break;
        if (here < 0) {
            low = z;
            at_low = here;
            if (side < 0) at_high *= 0.5;
            side = -1;
        } else {
            high = z;
            at_high = here;
            if (side > 0) at_low *= 0.5;
            side = 1;
        }
    }
    return z;
}

/// By how much forces differ from their estimates: the logarithm of the ratio, a straight line through what is known.
class Correction {
   public:
    void learn(double z, double logarithm) {
        before_ = now_;
        now_ = Known{z, logarithm};
    }
    double at(double z) const {
        if (!now_) return 0;
        const double apart = before_ ? now_->z - before_->z : 0;
        if (apart == 0) return now_->logarithm;
        const double slope = (now_->logarithm - before_->logarithm) / apart;
        return now_->logarithm + std::clamp(slope * (z - now_->z), -1.0, 1.0);
    }

   private:
    struct Known {
        double z, logarithm;
    };
    std::optional<Known> before_, now_;
};

class Search {
   public:
    explicit Search(const HeightTask& task) : task_(task), low_(task.touch), high_(task.deepest) {}

    HeightFound run() {
        HeightFound found{task_.touch, {0, std::numeric_limits<double>::infinity(), false, 0}};
        double z = next();
        for (int solve = 1; solve <= task_.settings.max_iterations; ++solve) {
            const double force = task_.force(z);
            found = {z, {solve, std::abs(force - task_.target) / task_.target, false, 0}};
            found.evidence.converged = found.evidence.residual <= task_.settings.tolerance;
            if (found.evidence.converged) break;
            (force < task_.target ? low_ : high_) = z;
            if (high_ - low_ < 1e-12 * (1 + std::abs(high_))) break;
            const double estimate = task_.estimate(z);
            if (force > 0 && estimate > 0) correction_.learn(z, std::log(force / estimate));
            const double last = z;
            z = force > 0 && estimate > 0 ? next() : 0.5 * (low_ + high_);
            if (z == last) break;
        }
        return found;
    }

   private:
    // Where the corrected estimate has the force that is wanted, within the bounds that the forces have given.
    double next() const {
        const double wanted = straightened(task_.target);
        const auto excess = [&](double z) {
            return straightened(task_.estimate(z) * std::exp(correction_.at(z))) / wanted - 1;
        };
        double low = low_, high = low_, step = 0.02, at_low = excess(low_), at_high = at_low;
        if (at_low >= 0) return std::midpoint(low_, std::min(high_, low_ + step));
        while (at_high < 0 && high < high_) {
            low = high;
            at_low = at_high;
            high = std::min(high + step, high_);
            at_high = excess(high);
            step *= 2;
        }
        if (at_high < 0) return std::midpoint(low_, high_);
        return rising_root(excess, low, high, at_low, at_high);
    }

    const HeightTask& task_;
    double low_, high_;
    Correction correction_;
};

}  // namespace

HeightFound find_height(const HeightTask& task) {
    return Search(task).run();
}

}  // namespace contactd

#include "rising_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace contactd {
namespace {

class Search {
   public:
    explicit Search(const RisingTask& task) : task_(task) {}

    RisingFound run() {
        RisingFound found;
        double x = std::clamp(task_.start, task_.low, task_.high), step = task_.step;
        for (int evaluation = 1; evaluation <= task_.max_evaluations; ++evaluation) {
            const Point here{x, task_.function(x)};
            found = {here.x, here.value, evaluation, std::abs(here.value) <= task_.tolerance};
            if (found.converged || std::isnan(here.value)) break;
            double next = x;
            learn(here);
            if (below_ && above_) {
                next = between();
            } else {
                const double limit = here.value < 0 ? task_.high : task_.low;
                if (x == limit) break;
                next = std::clamp(x + (here.value < 0 ? step : -step), task_.low, task_.high);
                step *= 4;
            }
            if (next == x || (below_ && above_ && above_->x - below_->x <= 1e-14 * std::abs(x))) break;
            x = next;
        }
        return found;
    }

   private:
    struct Point {
        double x, value;
    };

    void learn(const Point& here) {
        std::optional<Point>& same = here.value < 0 ? below_ : above_;
        std::optional<Point>& other = here.value < 0 ? above_ : below_;
        // After two points on one side, the value at the other end is outdated, and its weight is halved (Illinois).
        if (same && other && last_side_ == (here.value < 0)) other->value *= 0.5;
        last_side_ = here.value < 0;
        same = here;
    }

    double between() const {
        const double next = (below_->x * above_->value - above_->x * below_->value) / (above_->value - below_->value);
        return next > below_->x && next < above_->x ? next : 0.5 * (below_->x + above_->x);
    }

    const RisingTask& task_;
    std::optional<Point> below_, above_;  // points where the function is negative, and positive
    std::optional<bool> last_side_;
};

}  // namespace

RisingFound find_rising(const RisingTask& task) {
    return Search(task).run();
}

}  // namespace contactd

#include "force_search.hpp"

#include <chrono>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double tolerance = 1e-9;  // relative to the bound
constexpr int max_iterations = 100;

// Searches in units of bound and scale. Components that are not prescribed have no equation and do not change.
class Search {
   public:
    Search(const std::function<Pair(const Pair&)>& force, const PrescribedForce& prescribed, const Pair& scale)
        : force_(force), prescribed_{prescribed.Fx, prescribed.Fy}, bound_(prescribed.bound), scale_(scale) {}

    Pair residual(const Pair& motion) const {
        const Pair F = force_(motion);
        Pair r{};
        for (int i = 0; i < 2; ++i)
            if (prescribed_[i]) r[i] = (F[i] - *prescribed_[i]) / bound_;
        return r;
    }

    // Returns the columns dr/d(motion[j]/scale[j]), by differences.
    std::array<Pair, 2> jacobian(const Pair& motion, const Pair& r) const {
        constexpr double step = 1e-6;
        std::array<Pair, 2> columns{};
        for (int j = 0; j < 2; ++j) {
            if (!prescribed_[j]) continue;
            Pair moved = motion;
            moved[j] += step * scale_[j];
            const Pair there = residual(moved);
            for (int i = 0; i < 2; ++i) columns[j][i] = (there[i] - r[i]) / step;
        }
        return columns;
    }

    // Solves (J'J + damping) step = -J'r.
    Pair moved(const Pair& motion, const std::array<Pair, 2>& J, const Pair& r, double damping) const {
        const auto dot = [](const Pair& u, const Pair& v) { return u[0] * v[0] + u[1] * v[1]; };
        const double xx = dot(J[0], J[0]) + damping, yy = dot(J[1], J[1]) + damping, xy = dot(J[0], J[1]);
        const double bx = -dot(J[0], r), by = -dot(J[1], r), determinant = xx * yy - xy * xy;
        return {motion[0] + scale_[0] * (bx * yy - by * xy) / determinant,
                motion[1] + scale_[1] * (by * xx - bx * xy) / determinant};
    }

   private:
    const std::function<Pair(const Pair&)>& force_;
    std::array<std::optional<double>, 2> prescribed_;
    double bound_;
    Pair scale_;
};

double size_of(const Pair& r) {
    return std::hypot(r[0], r[1]);
}

}  // namespace

void check_reach(const PrescribedForce& prescribed, const char* field) {
    const double force = std::hypot(prescribed.Fx.value_or(0), prescribed.Fy.value_or(0));
    if (force > 0 && !(force < prescribed.bound))
        throw InvalidArgument(field, "is " + number_text(force) +
                                         " N; it must be less than mu Fn = " + number_text(prescribed.bound) + " N");
}

std::optional<SolverEvidence> find_motion(const std::function<Pair(const Pair&)>& force,
                                          const PrescribedForce& prescribed, const Pair& scale, Pair& motion) {
    if (!prescribed.Fx && !prescribed.Fy) return std::nullopt;
    if (!(prescribed.bound > 0)) return SolverEvidence{0, 0, true, 0};  // The force is zero for any motion.
    const auto start = std::chrono::steady_clock::now();
    const Search search(force, prescribed, scale);
    SolverEvidence evidence;
    Pair r = search.residual(motion);
    double damping = 1e-6;
    while (size_of(r) > tolerance && evidence.iterations < max_iterations) {
        ++evidence.iterations;
        const auto J = search.jacobian(motion, r);
        bool better = false;
        for (; !better && damping < 1e6; damping *= better ? 0.01 : 10) {
            const Pair trial = search.moved(motion, J, r, damping);
            const Pair there = search.residual(trial);
            better = size_of(there) < size_of(r);
            if (better) motion = trial, r = there;
        }
        if (!better) break;
        damping = std::max(damping, 1e-14);
    }
    evidence.residual = size_of(r);
    evidence.converged = evidence.residual <= tolerance;
    evidence.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return evidence;
}

}  // namespace contactd

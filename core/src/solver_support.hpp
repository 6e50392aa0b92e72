// Small helpers the contact solvers share.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string>

#include "contactd/error.hpp"
#include "contactd/observer.hpp"

namespace contactd {

inline double dot(std::span<const double> a, std::span<const double> b) {
    using Vector = Eigen::Map<const Eigen::VectorXd>;
    const auto size = static_cast<Eigen::Index>(a.size());
    return Vector(a.data(), size).dot(Vector(b.data(), size));
}

inline void require_size(std::span<const double> values, std::size_t size, const char* field) {
    if (values.size() != size)
        throw InvalidArgument(field, "has " + std::to_string(values.size()) + " values; the grid has " +
                                         std::to_string(size) + " elements");
}

/// How far an iteration has come from `first` to `tolerance` when residuals fall geometrically, 0..1.
inline double log_fraction(double first, double residual, double tolerance) {
    if (residual <= tolerance) return 1;
    if (!(first > tolerance)) return 0;
    return std::clamp(std::log(first / residual) / std::log(first / tolerance), 0.0, 1.0);
}

/// Passes on the wish to cancel and no progress: for solves within a solve.
class SilentObserver final : public Observer {
   public:
    explicit SilentObserver(const Observer& outer) : outer_(outer) {}
    bool cancelled() const override { return outer_.cancelled(); }

   private:
    const Observer& outer_;
};

class Stopwatch {
   public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace contactd

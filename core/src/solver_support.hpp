// Small helpers the contact solvers share.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "contactd/error.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Several partial sums, so that an addition need not wait for the one before.
inline double dot(std::span<const double> a, std::span<const double> b) {
    constexpr std::size_t lanes = 8;
    const double *x = a.data(), *y = b.data();
    const std::size_t whole = a.size() / lanes * lanes;
    std::array<double, lanes> sums = {};
    for (std::size_t i = 0; i < whole; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += x[i + lane] * y[i + lane];
    for (std::size_t i = whole; i < a.size(); ++i) sums[0] += x[i] * y[i];
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
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

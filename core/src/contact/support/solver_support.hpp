// Defines small helpers of the contact solvers.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string>

#include "contactd/error.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "traction_loops.hpp"

namespace contactd {

inline double dot(std::span<const double> a, std::span<const double> b) {
    return dot_product(a.size(), a.data(), b.data());
}

inline void require_size(std::span<const double> values, std::size_t size, const char* field) {
    if (values.size() != size)
        throw InvalidArgument(field, "has " + std::to_string(values.size()) + " values; the grid has " +
                                         std::to_string(size) + " elements");
}

/// Returns the grid of the larger elements.
inline Grid coarser(Grid grid, const CoarserGrid& coarse) {
    grid.dx *= coarse.along_x();
    grid.dy *= coarse.along_y();
    grid.nx = (grid.nx + coarse.along_x() - 1) / coarse.along_x();
    grid.ny = (grid.ny + coarse.along_y() - 1) / coarse.along_y();
    return grid;
}

/// Returns the progress of an iteration from `first` to `tolerance`, 0..1, for residuals that decrease geometrically.
inline double log_fraction(double first, double residual, double tolerance) {
    if (residual <= tolerance) return 1;
    if (!(first > tolerance)) return 0;
    return std::clamp(std::log(first / residual) / std::log(first / tolerance), 0.0, 1.0);
}

/// Forwards cancellation, but no progress, for solves within a solve.
class SilentObserver final : public Observer {
   public:
    explicit SilentObserver(const Observer& outer) : outer_(outer) {}
    bool cancelled() const override { return outer_.cancelled(); }
    std::string_view user() const override { return outer_.user(); }

   private:
    const Observer& outer_;
};

/// Reports the progress of one solver as a part of the whole computation.
class PartObserver : public Observer {
   public:
    PartObserver(Observer& whole, double first, double last) : whole_(whole), first_(first), last_(last) {}
    void on_progress(const Progress& part) override {
        Progress progress = part;
        progress.fraction = first_ + part.fraction * (last_ - first_);
        whole_.on_progress(progress);
    }
    bool cancelled() const override { return whole_.cancelled(); }
    std::string_view user() const override { return whole_.user(); }

   private:
    Observer& whole_;
    const double first_, last_;
};

/// Reports iterations of unknown number, 1, 2, ...; each takes a share of the remaining progress.
class IterationObserver final : public PartObserver {
   public:
    IterationObserver(Observer& whole, int iteration, double share = 0.3)
        : PartObserver(whole, 1 - std::pow(1 - share, iteration - 1), 1 - std::pow(1 - share, iteration)) {}
};

class Stopwatch {
   public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace contactd

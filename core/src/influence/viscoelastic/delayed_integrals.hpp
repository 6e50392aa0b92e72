// Integrals of the half-space over a load, averaged over what a body that creeps remembers of the way it came.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "influence/half_space_model.hpp"

namespace contactd {

/// Weights of a Gauss rule on a panel of s, 0 to h: sum of weight g(node) is the integral of g(s) exp(-s/l)/l for the
/// polynomial through the values of g, whatever h/l is.
class DelayWeights {
   public:
    static constexpr std::size_t points = 14;

    explicit DelayWeights(double length_over_l);
    double operator[](std::size_t i) const { return weights_[i]; }
    /// In shares of the panel.
    static double node(std::size_t i);

   private:
    std::array<double, points> weights_{};
};

/// With K those of HalfSpaceModel, the integral over s from 0 to infinity of K(x + s, y) exp(-s/l)/l: a particle at x
/// was at x + s that long ago. Relative accuracy 1e-12 of the largest one.
class DelayedIntegrals {
   public:
    /// At the offsets (k + shift) dx, first_k <= k <= last_k; `l` (mm) > 0 and finite.
    DelayedIntegrals(const HalfSpaceModel& model, double dx, double dy, int first_k, int last_k, double shift,
                     double l);

    /// Returns those of the row at y, one for each k.
    std::vector<KernelIntegrals> row(double y);

   private:
    struct Panel {
        double x, length, decay;  // decay: exp(-s/l) where it begins
        DelayWeights weights;
    };

    KernelIntegrals panel(double x, double y, int level);
    KernelIntegrals sum(double x, double y, double length, const DelayWeights& weights) const;
    bool is_smooth(double x, double y, double length) const;
    const DelayWeights& weights_of(int level);

    const HalfSpaceModel model_;
    const double dx_, dy_, l_;
    const int first_k_, last_k_, end_k_;
    const double shift_;
    const double reach_;  // of the load along x, from its centre
    std::vector<double> edges_;
    std::map<int, DelayWeights> of_level_;
    std::vector<Panel> beyond_;
};

}  // namespace contactd

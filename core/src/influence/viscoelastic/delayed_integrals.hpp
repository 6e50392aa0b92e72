// Computes integrals of the half-space over a load, averaged over the memory of a viscoelastic body.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "influence/half_space_model.hpp"

namespace contactd {

/// Holds weights of a Gauss rule on a panel of s, 0 to h: the sum of weight g(node) is the integral of g(s) exp(-s/l)/l
/// for the polynomial through the values of g, whatever h/l is.
class DelayWeights {
   public:
    static constexpr std::size_t points = 14;

    explicit DelayWeights(double length_over_l);
    double operator[](std::size_t i) const { return weights_[i]; }
    /// Returns a node as a fraction of the panel.
    static double node(std::size_t i);

   private:
    std::array<double, points> weights_{};
};

/// Computes the integral over s from 0 to infinity of K(x + s, y) exp(-s/l)/l, with K of HalfSpaceModel: a particle at
/// x was at x + s that long ago. The relative accuracy is 1e-12 of the largest one.
class DelayedIntegrals {
   public:
    /// Offsets are (k + shift) dx, first_k <= k <= last_k; `l` (mm) is > 0 and finite.
    DelayedIntegrals(const HalfSpaceModel& model, double dx, double dy, int first_k, int last_k, double shift,
                     double l);

    /// Returns the integrals of the row at y, one for each k.
    std::vector<KernelIntegrals> row(double y);

   private:
    struct Panel {
        double x, length, decay;  // decay: exp(-s/l) at its beginning
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
    const double reach_;  // extent of the load along x, from its centre
    std::vector<double> edges_;
    std::map<int, DelayWeights> of_level_;
    std::vector<Panel> beyond_;
};

}  // namespace contactd

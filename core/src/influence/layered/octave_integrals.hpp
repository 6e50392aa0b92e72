// Computes integrals over the wavenumber, for the distances of successive octaves. Above the least wavenumber of the
// octave it uses Bessel functions, on a rule that is the same for all octaves. Below, it uses moments of the
// compliance, which octaves share.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "influence/layered/gauss_legendre.hpp"
#include "influence/layered/radial_function.hpp"
#include "influence/layered/wavenumbers.hpp"

namespace contactd {

class OctaveIntegrals {
   public:
    /// The r(k) of regularised kernels is exp(-(k largest/4)^2).
    OctaveIntegrals(const Layers& body, std::vector<RadialFunction> functions, double largest);

    using Values = std::array<std::vector<double>, Wavenumbers::radii>;  ///< [radius][function]
    /// Returns the integrals at the rule's distances times p. Call it in the order of decreasing p.
    Values at_nodes(double p);

   private:
    static constexpr std::size_t terms = 3;
    /// Holds moments of one function, over the wavenumbers below those of the octave.
    struct Moments {
        std::array<double, terms> powers{};  ///< with the powers of k of the kernel's series
        double regularisation = 0;           ///< part of the regularisation, without rho/2 where that is a factor
    };
    struct Series;
    static Series series_of(RadialFunction::Kernel kernel);

    double lacking(double k) const;  ///< 1 - r(k)
    void add_moments(double to);
    void add_panel(double from, double to);
    void weigh(double p);
    double value(std::size_t function, std::size_t radius, double p) const;

    LayeredWaves waves_;
    std::vector<RadialFunction> functions_;
    double length_, smallest_, G_;
    std::vector<GaussPoint> gauss_;
    double below_ = 0;  // upper end of the moments
    std::vector<Moments> moments_;
    std::vector<std::vector<double>> weighted_;  // [function][wavenumber] of the octave
    std::vector<double> added_;                  // [function] part that the regularisation adds there
};

}  // namespace contactd

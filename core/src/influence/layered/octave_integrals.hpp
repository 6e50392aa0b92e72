// Integrals over the wavenumber, for the distances of one octave after the other: above the least wavenumber of the
// octave by Bessel functions, on a rule that is the same for all; below it by moments of the compliance, which octaves
// share.
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
    /// r(k) of regularised kernels is exp(-(k largest/4)^2).
    OctaveIntegrals(const Layers& body, std::vector<RadialFunction> functions, double largest);

    using Values = std::array<std::vector<double>, Wavenumbers::radii>;  ///< [radius][function]
    /// At the rule's distances times p. Call it in the order of falling p.
    Values at_nodes(double p);

   private:
    static constexpr std::size_t terms = 3;
    /// Moments of one function, over the wavenumbers below those of the octave.
    struct Moments {
        std::array<double, terms> powers{};  ///< with the powers of k of the kernel's series
        double regularisation = 0;           ///< of what the regularisation adds, without rho/2 where that is a factor
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
    double below_ = 0;  // where the moments end
    std::vector<Moments> moments_;
    std::vector<std::vector<double>> weighted_;  // [function][wavenumber] of the octave
    std::vector<double> added_;                  // [function] what the regularisation adds there
};

}  // namespace contactd

// A section by finite elements: what loads on its strips do to its strips at a wavenumber.
#pragma once

#include <memory>
#include <vector>

#include "strip_vectors.hpp"
#include "wave_factor.hpp"

namespace contactd::fem {

/// One wavenumber's part of a StripSpectrum, symmetric.
struct WaveResponse {
    std::vector<double> values;     ///< a >= b at a (a + 1)/2 + b
    double reciprocity_defect = 0;  ///< largest |A - A'| before it was made symmetric
};

class SectionModel {
   public:
    /// Lengths over ds, G = 1. `mesh` may serve models of several orders up to that it was made with.
    SectionModel(const SectionOutline& outline, const SectionMesh& mesh, int order, double nu);

    /// Throws NotConverged when the matrix is not positive definite to rounding: nothing holds the body at xi = 0.
    WaveResponse at(double xi);

    long long unknowns() const { return matrices_.pattern().size(); }
    const WaveFactor& factor() const { return factor_; }

   private:
    WaveMatrices matrices_;
    SparseColumns loads_, observations_;
    WaveFactor factor_;
};

}  // namespace contactd::fem

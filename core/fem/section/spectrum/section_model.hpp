// Models a section by finite elements: the displacements of its strips under loads on them at a wavenumber.
#pragma once

#include <memory>
#include <vector>

#include "strip_vectors.hpp"
#include "wave_factor.hpp"

namespace contactd::fem {

/// Holds the part of a StripSpectrum at one wavenumber, which is symmetric.
struct WaveResponse {
    std::vector<double> values;     ///< a >= b at a (a + 1)/2 + b
    double reciprocity_defect = 0;  ///< largest |A - A'| before symmetrisation
};

class SectionModel {
   public:
    /// Lengths are divided by ds, and G = 1. `mesh` may serve models of several orders, up to the order it was made
    /// with.
    SectionModel(const SectionOutline& outline, const SectionMesh& mesh, int order, double nu);

    /// Throws NotConverged if the matrix is not positive definite to rounding, because nothing holds the body at xi =
    /// 0.
    WaveResponse at(double xi);

    long long unknowns() const { return matrices_.pattern().size(); }
    const WaveFactor& factor() const { return factor_; }

   private:
    WaveMatrices matrices_;
    SparseColumns loads_, observations_;
    WaveFactor factor_;
};

}  // namespace contactd::fem

// Computes the products O' K^-1 B for sparse B and O, by one Cholesky factor and two forward solves: (L^-1 O)' (L^-1
// B). Each supernode processes only columns whose loads are below it in the elimination tree.
#pragma once

#include <memory>
#include <vector>

#include "strip_vectors.hpp"

namespace contactd::fem {

class WaveFactor {
   public:
    /// Orders and analyses the pattern, for all wavenumbers. Throws std::bad_alloc.
    explicit WaveFactor(const LowerPattern& pattern);
    ~WaveFactor();
    WaveFactor(const WaveFactor&) = delete;
    WaveFactor& operator=(const WaveFactor&) = delete;

    double operations() const;  ///< of a factorisation
    double entries() const;     ///< of the factor

    /// Throws NotConverged if the matrix is not positive definite to rounding.
    void factorise(std::vector<double> values);

    /// Returns observations' K^-1 loads, [observation + load * observations].
    std::vector<double> response(const SparseColumns& observations, const SparseColumns& loads) const;

   private:
    class Forward;
    struct Library;
    const LowerPattern& pattern_;
    std::unique_ptr<Library> library_;
};

}  // namespace contactd::fem

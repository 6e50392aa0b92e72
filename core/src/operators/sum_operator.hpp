// Adds the displacements of two bodies whose tables are of different kinds and cannot be added.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contactd/influence_operator.hpp"
#include "lazy.hpp"
#include "sum_terms.hpp"

namespace contactd {

/// Implements the sum of the operators of two bodies, as pair_of does for tables: adds xx, yy, zz, xy, yx and subtracts
/// xz, yz, zx, zy of the upper body from those of the lower. It has coarser grids and boxes if both bodies have them.
class SumOperator final : public InfluenceOperator {
   public:
    /// Throws InvalidArgument if there is no body, or if the numbers of elements differ.
    explicit SumOperator(OfBodies<InfluenceOperator> bodies);
    ~SumOperator() override;

    std::size_t size() const override { return size_; }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::vector<double> diagonal(Axis i) const override;
    /// Applies each body's preconditioner between its parts of the diagonal: z = sum_b W_b M_b W_b r, W_b = D_b/(D_1 +
    /// D_2). It is the inverse of the sum if the bodies are multiples of each other, and always symmetric and positive
    /// definite.
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    std::size_t bytes() const override;
    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override;

   private:
    class Boxes;
    struct Term {
        std::shared_ptr<const InfluenceOperator> body;
        double coupling_sign;
        std::array<std::vector<double>, 3> share{};  // W_b of each axis
    };
    const Term& first() const { return terms_.front(); }
    std::size_t size_ = 0;
    std::vector<Term> terms_;
    mutable Lazy<std::unique_ptr<const CoarserGrid>> coarser_;
    std::unique_ptr<const ElementBoxes> boxes_;
};

}  // namespace contactd

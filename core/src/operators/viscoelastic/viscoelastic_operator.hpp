// Implements the influence operator of rolling viscoelastic half-spaces, which is Toeplitz in both directions and not
// symmetric.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"
#include "influence/viscoelastic/rolling_table.hpp"

namespace contactd {

/// Describes the effect of a body's creep on waves along x, of wavenumber k: its compliance times 1 + f/(1 - i k l).
struct CreepOfWaves {
    double f = 0, l = 0;            ///< l (mm) is negative if the bodies roll along -x
    std::array<double, 3> share{};  ///< share of the body in the compliance of the pair along x, y and z
};

/// Computes products by FFTs of the table. The preconditioner is the elastic one times the reciprocal of the effect of
/// creep on waves, which ignores the end of the table.
class ViscoelasticOperator final : public InfluenceOperator {
   public:
    /// `elastic` holds the instantaneous coefficients of the pair, `table` those of rolling, both with the extent of
    /// the grid; `dx` is the size of an element.
    ViscoelasticOperator(IcTable elastic, RollingTable table, std::vector<CreepOfWaves> creep, double dx);
    ~ViscoelasticOperator() override;

    std::size_t size() const override;
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    bool is_symmetric() const override { return false; }
    std::vector<double> diagonal(Axis i) const override;
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    std::size_t bytes() const override { return size() * bytes_per_element; }
    /// It approximates the memory of both tables, symbols of five to nine components on a padded grid, coarser grids,
    /// and some boxes.
    static constexpr std::size_t bytes_per_element = 2000;

    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override;

   private:
    class Boxes;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace contactd

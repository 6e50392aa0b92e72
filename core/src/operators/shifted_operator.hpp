// Computes products with a table that is Toeplitz in both directions and has no parity, by FFTs.
#pragma once

#include <memory>

#include "contactd/step_operator.hpp"
#include "influence/shifted_table.hpp"

namespace contactd {

/// Implements the operator of a ShiftedTable, as ConvolutionOperator does for an IcTable. With the table of
/// change_over_step it is the increment over a step.
class ShiftedOperator final : public StepOperator {
   public:
    explicit ShiftedOperator(ShiftedTable table);
    ~ShiftedOperator() override;
    ShiftedOperator(ShiftedOperator&&) noexcept;
    ShiftedOperator& operator=(ShiftedOperator&&) noexcept;

    std::size_t size() const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    /// Returns whether the coupling relative to xx exceeds coupling_tolerance.
    bool coupled() const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::size_t bytes() const override { return size() * bytes_per_element; }
    /// It approximates the memory of the table, symbols, inverses, coarser grids, and some boxes.
    static constexpr std::size_t bytes_per_element = 600;

    std::shared_ptr<const StepInverse> inverse(double added) const override;
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override;

   private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace contactd

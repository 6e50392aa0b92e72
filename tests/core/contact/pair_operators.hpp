// Creates operators of two bodies for the contact tests: of half-spaces, or of flat bodies with a cross-section if
// CONTACTD_TEST_BODIES is flat_strips. Every test of contact thus runs with both kinds.
#pragma once

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "bodies/strip_influence.hpp"
#include "contactd/contact_influence.hpp"
#include "operators/convolution.hpp"
#include "operators/strips/strip_operator.hpp"

namespace contactd::test {

inline bool on_flat_strips() {
    const char* bodies = std::getenv("CONTACTD_TEST_BODIES");
    return bodies != nullptr && std::string_view(bodies) == "flat_strips";
}

/// Holds the operator of a pair's table, of a kind that the test does not depend on.
class PairOperator final : public InfluenceOperator {
   public:
    PairOperator(const IcTable& pair, int nx, int ny) : inner_(make(pair, nx, ny)) {}

    std::size_t size() const override { return inner_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override { inner_->normal(pz, uz); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        inner_->tangential(px, py, ux, uy);
    }
    bool coupled() const override { return inner_->coupled(); }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override {
        inner_->normal_of_tangential(px, py, uz);
    }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        inner_->tangential_of_normal(pz, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override { return inner_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        inner_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        inner_->precondition_tangential(rx, ry, zx, zy);
    }
    std::size_t bytes() const override { return inner_->bytes(); }
    const CoarserGrid* coarser() const override { return inner_->coarser(); }
    const ElementBoxes* boxes() const override { return inner_->boxes(); }

    static std::shared_ptr<const InfluenceOperator> make(const IcTable& pair, int nx, int ny) {
        auto half_spaces = std::make_shared<const ConvolutionOperator>(pair, nx, ny);
        if (!on_flat_strips()) return half_spaces;
        const auto parts = std::make_shared<const StripParts>(strip_table_of(cropped(pair, nx, ny)), nx);
        return std::make_shared<const StripOperator>(parts, parts->extent(), std::move(half_spaces));
    }

   private:
    const std::shared_ptr<const InfluenceOperator> inner_;
};

/// Creates operators like make_influence. Flat bodies with a cross-section can only roll along x, and given tables do
/// not define other steps, so these use half-spaces.
inline ContactInfluence operators_of(const ContactProblem& problem, const IcTable& pair) {
    ContactInfluence influence = make_influence(problem, pair);
    if (!on_flat_strips() || problem.bodies.any_viscoelastic()) return influence;
    const Grid& grid = problem.grid;
    const auto [x, y] = step_of(problem);
    const bool along_x = std::abs(y) <= 1e-9 * std::abs(x) && std::abs(x) <= grid.nx * grid.dx;
    const bool known = !problem.bodies.any_given() && !problem.bodies.any_layered();
    if (along_x && known) return strip_influence(problem, strip_table_of(cropped(pair, pair.nx, grid.ny)));
    influence.current = PairOperator::make(pair, grid.nx, grid.ny);
    return influence;
}

}  // namespace contactd::test

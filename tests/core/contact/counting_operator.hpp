// Counts the products that a solver requests from an operator.
#pragma once

#include <memory>
#include <utility>

#include "contactd/contact_influence.hpp"

namespace contactd::test {

struct ProductCounts {
    int normal = 0, tangential = 0;
};

/// Forwards products and other functions, without coarser grids and boxes.
class CountingOperator final : public InfluenceOperator {
   public:
    CountingOperator(std::shared_ptr<const InfluenceOperator> counted, ProductCounts& counts)
        : counted_(std::move(counted)), counts_(counts) {}

    std::size_t size() const override { return counted_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override {
        ++counts_.normal;
        counted_->normal(pz, uz);
    }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        ++counts_.tangential;
        counted_->tangential(px, py, ux, uy);
    }
    bool coupled() const override { return counted_->coupled(); }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override {
        counted_->normal_of_tangential(px, py, uz);
    }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        counted_->tangential_of_normal(pz, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override { return counted_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        counted_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        counted_->precondition_tangential(rx, ry, zx, zy);
    }
    std::size_t bytes() const override { return counted_->bytes(); }

   private:
    std::shared_ptr<const InfluenceOperator> counted_;
    ProductCounts& counts_;
};

/// Counts the products with the increment over a step of rolling.
class CountingStep final : public StepOperator {
   public:
    CountingStep(std::shared_ptr<const StepOperator> counted, ProductCounts& counts)
        : counted_(std::move(counted)), counts_(counts) {}

    std::size_t size() const override { return counted_->size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        ++counts_.tangential;
        counted_->tangential(px, py, ux, uy);
    }
    bool coupled() const override { return counted_->coupled(); }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        counted_->tangential_of_normal(pz, ux, uy);
    }
    std::size_t bytes() const override { return counted_->bytes(); }

   private:
    std::shared_ptr<const StepOperator> counted_;
    ProductCounts& counts_;
};

/// `counts` outlives the result.
inline ContactInfluence counted(const ContactInfluence& influence, ProductCounts& counts) {
    ContactInfluence result;
    result.current = std::make_shared<CountingOperator>(influence.current, counts);
    if (influence.increment) result.increment = std::make_shared<CountingStep>(influence.increment, counts);
    return result;
}

}  // namespace contactd::test

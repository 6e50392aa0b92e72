// Counts products of an operator without coarser grids and boxes, which would accelerate solves.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "contact_cases.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd::test {

class PlainOperator final : public InfluenceOperator {
   public:
    explicit PlainOperator(std::shared_ptr<const InfluenceOperator> inner) : inner_(std::move(inner)) {}

    int products() const { return products_; }  ///< only uz = A_zz pz so far

    std::size_t size() const override { return inner_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override {
        ++products_;
        inner_->normal(pz, uz);
    }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        inner_->tangential(px, py, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override { return inner_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        inner_->precondition(i, r, z);
    }
    std::size_t bytes() const override { return inner_->bytes(); }

   private:
    const std::shared_ptr<const InfluenceOperator> inner_;
    mutable std::atomic<int> products_ = 0;
};

/// Counts the products in normal contact of half-spaces.
inline int products_of(const ContactProblem& problem) {
    const auto plain = std::make_shared<PlainOperator>(operators_of(problem, pair_table(problem)).current);
    Observer observer;
    (void)solve_contact(problem, {plain, nullptr}, observer);
    return plain->products();
}

}  // namespace contactd::test

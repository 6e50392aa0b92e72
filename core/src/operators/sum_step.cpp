#include "sum_step.hpp"

#include <utility>

namespace contactd {

using namespace sums;

SumStep::SumStep(OfBodies<StepOperator> bodies) : terms_(terms_of<Term>(bodies)) {
    size_ = terms_.front().body->size();
}

void SumStep::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                         std::span<double> uy) const {
    sum(terms_, ux, uy, plain, [&](const Term& term, auto x, auto y) { term.body->tangential(px, py, x, y); });
}

bool SumStep::coupled() const {
    return any_coupled(terms_);
}

void SumStep::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    sum(terms_, ux, uy, coupling, [&](const Term& term, auto x, auto y) { term.body->tangential_of_normal(pz, x, y); });
}

std::size_t SumStep::bytes() const {
    std::size_t bytes = 0;
    for (const Term& term : terms_) bytes += term.body->bytes();
    return bytes;
}

std::shared_ptr<const StepOperator> SumStep::on(const ElementBox& box) const {
    auto bodies = each<StepOperator>(terms_, [&](const StepOperator& body) { return body.on(box); });
    return none(bodies) ? nullptr : std::make_shared<const SumStep>(std::move(bodies));
}

const StepOperator* SumStep::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const StepOperator> {
        auto bodies = each<StepOperator>(terms_, [](const StepOperator& body) { return borrowed(body.coarser()); });
        return none(bodies) ? nullptr : std::make_unique<const SumStep>(std::move(bodies));
    };
    return coarser_.get(make).get();
}

}  // namespace contactd

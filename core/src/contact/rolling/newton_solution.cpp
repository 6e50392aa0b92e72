#include "newton_solution.hpp"

#include <vector>

namespace contactd {

RollingSolution solution_of(const FrictionNewton& newton, const Contact& contact, std::size_t n) {
    RollingSolution result;
    for (std::vector<double>* values : {&result.traction_x, &result.traction_y, &result.slip_x, &result.slip_y})
        values->resize(n);
    contact.scatter(newton.tractions().x, result.traction_x);
    contact.scatter(newton.tractions().y, result.traction_y);
    contact.scatter(newton.slip().x, result.slip_x);
    contact.scatter(newton.slip().y, result.slip_y);
    result.element_division.assign(n, ElementState::exterior);
    for (std::size_t e = 0; e < contact.size(); ++e)
        result.element_division[contact.elements[e]] = newton.slips()[e] ? ElementState::slip : ElementState::adhesion;
    result.evidence = newton.evidence();
    return result;
}

RollingSolution whole_of(const RollingSolution& part, const Restriction& restriction, std::size_t n) {
    RollingSolution whole;
    const auto paste = [&](const auto& from, auto& to) {
        to.resize(n);
        restriction.paste(from, to);
    };
    paste(part.traction_x, whole.traction_x);
    paste(part.traction_y, whole.traction_y);
    paste(part.slip_x, whole.slip_x);
    paste(part.slip_y, whole.slip_y);
    paste(part.element_division, whole.element_division);
    whole.evidence = part.evidence;
    return whole;
}

}  // namespace contactd

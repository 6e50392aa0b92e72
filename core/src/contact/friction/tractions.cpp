#include "tractions.hpp"

#include <cmath>
#include <variant>

#include "contact/support/solver_support.hpp"

namespace contactd {

using Values = std::vector<double>;

Tractions make_tractions(std::size_t n, const Values& pressure, const Values& x, const Values& y) {
    Tractions result{pressure, Field(0)};
    result.tangential.x = x;
    result.tangential.y = y;
    for (Values* values : {&result.pressure, &result.tangential.x, &result.tangential.y}) values->resize(n);
    return result;
}

double relative_change(const Tractions& now, const Tractions& before) {
    double change = 0, size = 0;
    const auto add = [&](const Values& a, const Values& b) {
        using Vector = Eigen::Map<const Eigen::VectorXd>;
        const auto n = static_cast<Eigen::Index>(a.size());
        change += (Vector(a.data(), n) - Vector(b.data(), n)).squaredNorm();
        size += dot(a, a);
    };
    add(now.pressure, before.pressure);
    add(now.tangential.x, before.tangential.x);
    add(now.tangential.y, before.tangential.y);
    return size > 0 ? std::sqrt(change / size) : 0;
}

Tractions first_estimate(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    const SurfaceState& before = problem.previous;
    const bool has_tractions = !problem.initial.traction_x.empty() || !problem.initial.traction_y.empty();
    const bool takes_last = !has_tractions && !(rolling && rolling->steady());
    return make_tractions(problem.grid.size(),
                          problem.initial.pressure.empty() ? before.pressure : problem.initial.pressure,
                          takes_last ? before.traction_x : problem.initial.traction_x,
                          takes_last ? before.traction_y : problem.initial.traction_y);
}

}  // namespace contactd

#include "coarse_start.hpp"

#include "contact/newton/friction_newton.hpp"
#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double coarse_tolerance = 1e-2;  // tolerance of an estimate, which has the coarser grid's error anyway
constexpr int most_coarse_iterations = 40;

std::optional<FrictionBodies> coarser(const FrictionBodies& bodies) {
    const CoarserGrid* coarse = bodies.influence.coarser();
    const StepOperator* increment = bodies.increment == nullptr ? nullptr : bodies.increment->coarser();
    if (coarse == nullptr || (bodies.increment != nullptr && increment == nullptr)) return {};
    const Grid grid = coarser(bodies.grid, *coarse);
    if (coarse->influence().size() != grid.size() || (increment != nullptr && increment->size() != grid.size()))
        return {};
    return FrictionBodies{coarse->influence(), increment, grid, bodies.step_x, bodies.step_y};
}

}  // namespace

FrictionStart start_on_coarser(const FrictionBodies& fine, const Contact& contact,
                               const std::optional<ForcesGiven>& forces, const Pair& uniform, const FlowLaw* flow,
                               const Observer& observer) {
    const FrictionStart none{Field(fine.grid.size()), uniform};
    const std::optional<FrictionBodies> bodies = coarser(fine);
    if (!bodies) return none;
    const CoarserGrid& grid = *fine.influence.coarser();
    const auto to_coarser = [&](const Values& on_contact) {
        Values whole(fine.grid.size()), coarse(bodies->grid.size());
        contact.scatter(on_contact, whole);
        grid.average(whole, coarse);
        return coarse;
    };
    // Means of the rigid slip are over elements in contact, because it is unknown beyond.
    const Values share = to_coarser(Values(contact.size(), 1.0));
    const auto mean = [&](const Values& on_contact) {
        Values values = to_coarser(on_contact);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] /= share[i] > 0 ? share[i] : 1;
        return values;
    };
    const Contact coarse(to_coarser(contact.bound), mean(contact.rigid.x), mean(contact.rigid.y));
    std::optional<ForcesGiven> coarse_forces = forces;
    if (coarse_forces) {
        coarse_forces->sum /= grid.ratio();
        coarse_forces->tolerance = coarse_tolerance;
    }
    std::optional<FlowLaw> coarse_flow;
    if (flow != nullptr) {
        coarse_flow.emplace(FlowLaw{flow->first, flow->hardening, flow->least, Values(coarse.size()), {}});
        if (flow->upstream)
            coarse_flow->upstream.emplace(bodies->grid, bodies->step_x, bodies->step_y, coarse.elements);
        else
            coarse.gather(mean(flow->before), coarse_flow->before);
    }
    const FlowLaw* law = coarse_flow ? &*coarse_flow : nullptr;
    const auto compliance = compliance_of(*bodies, coarse);
    FrictionNewton newton(*compliance, coarse, coarse_forces, law);
    const FrictionStart start = start_on_coarser(*bodies, coarse, coarse_forces, uniform, law, observer);
    newton.start(start.tractions, start.uniform);
    SilentObserver silent(observer);
    if (!newton.iterate(most_coarse_iterations, {coarse_tolerance, most_coarse_iterations}, silent)) return none;
    Field tractions(bodies->grid.size());
    coarse.scatter(newton.tractions().x, tractions.x);
    coarse.scatter(newton.tractions().y, tractions.y);
    FrictionStart found{Field(fine.grid.size()), newton.rigid()};
    grid.interpolate(tractions.x, found.tractions.x);
    grid.interpolate(tractions.y, found.tractions.y);
    return found;
}

}  // namespace contactd

#include "friction_solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/newton/friction_newton.hpp"
#include "contact/rolling/coarse_start.hpp"
#include "contact/support/solver_support.hpp"
#include "operators/restriction.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr std::size_t smallest_to_coarsen = 1000;  // elements in contact
// From this number of elements on, a coarser grid is a better start than an estimate whose residual exceeds this over
// the number of elements along the contact. With forces, the rigid slip is computed there, too.
constexpr double poor_times_elements = 10, poor_times_elements_for_forces = 3;

// Returns the solution on the `n` elements that contain the contact.
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
        result.element_division[contact.elements[e]] = newton.flows(e)     ? ElementState::flow
                                                       : newton.slips()[e] ? ElementState::slip
                                                                           : ElementState::adhesion;
    result.evidence = newton.evidence();
    return result;
}

// Returns the solution of a box on all `n` elements, which are exterior outside the box.
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

}  // namespace

// Holds the data that remain valid as long as the contact area: its elements, operators on a box around them, and the
// iteration.
class FrictionSolver::Area {
   public:
    Area(const FrictionBodies& bodies, const FrictionTask& task)
        : size_(bodies.grid.size()),
          restriction_(bodies.influence,
                       bounding_box(extent_of(bodies.influence), [&](std::size_t i) { return task.bound[i] > 0; }),
                       false),
          increment_(bodies.increment == nullptr || restriction_.is_whole() ? nullptr
                                                                            : bodies.increment->on(restriction_.box())),
          is_whole_(restriction_.is_whole() || (bodies.increment != nullptr && !increment_)),
          bodies_(is_whole_ ? bodies
                            : FrictionBodies{restriction_.influence(), increment_.get(), restriction_.crop(bodies.grid),
                                             bodies.step_x, bodies.step_y}),
          contact_(crop(task.bound), crop(task.rigid.x), crop(task.rigid.y)),
          compliance_(compliance_of(bodies_, contact_)),
          flow_(flow_law(task)),
          newton_(*compliance_, contact_, task.forces, flow_ ? &*flow_ : nullptr) {}

    std::size_t elements() const { return contact_.size(); }

    bool stands(std::span<const double> bound) const {
        const Values g = crop(bound);
        std::size_t inside = 0;
        for (const std::size_t i : contact_.elements) {
            if (!(g[i] > 0)) return false;
            ++inside;
        }
        return static_cast<std::size_t>(std::count_if(bound.begin(), bound.end(), [](double b) { return b > 0; })) ==
               inside;
    }

    void start(const FrictionTask& task) {
        Field estimate;
        estimate.x = crop(task.estimate.x);
        estimate.y = crop(task.estimate.y);
        newton_.start(estimate, task.uniform);
    }

    void start_on_coarser(const FrictionTask& task, const Observer& observer) {
        const FrictionStart start = contactd::start_on_coarser(bodies_, contact_, task.forces, task.uniform,
                                                               flow_ ? &*flow_ : nullptr, observer);
        newton_.start(start.tractions, start.uniform);
    }

    void go_on(const FrictionTask& task) {
        contact_.gather(crop(task.bound), contact_.bound);
        contact_.gather(crop(task.rigid.x), contact_.rigid.x);
        contact_.gather(crop(task.rigid.y), contact_.rigid.y);
        newton_.go_on(task.forces);
    }

    FrictionNewton& newton() { return newton_; }

    FrictionSolution solution() const {
        FrictionSolution result;
        RollingSolution& found = result;
        found = solution_of(newton_, contact_, bodies_.grid.size());
        if (!is_whole_) found = whole_of(found, restriction_, size_);
        result.uniform = newton_.rigid();
        result.force_residual = newton_.force_residual();
        return result;
    }

    Field tractions() const {
        Field part(bodies_.grid.size());
        contact_.scatter(newton_.tractions().x, part.x);
        contact_.scatter(newton_.tractions().y, part.y);
        if (is_whole_) return part;
        Field whole(size_);
        restriction_.paste(part.x, whole.x);
        restriction_.paste(part.y, whole.y);
        return whole;
    }

   private:
    std::optional<FlowLaw> flow_law(const FrictionTask& task) const {
        if (task.flow == nullptr) return {};
        FlowLaw law{task.flow->first, task.flow->hardening, task.flow->least, Values(contact_.size()), {}};
        if (bodies_.increment != nullptr)
            law.upstream.emplace(bodies_.grid, bodies_.step_x, bodies_.step_y, contact_.elements);
        else
            contact_.gather(crop(task.flow->before), law.before);
        return law;
    }

    Values crop(std::span<const double> whole) const {
        return is_whole_ ? Values(whole.begin(), whole.end()) : restriction_.crop(whole);
    }

    const std::size_t size_;
    const Restriction restriction_;
    const std::shared_ptr<const StepOperator> increment_;
    const bool is_whole_;
    const FrictionBodies bodies_;
    Contact contact_;
    const std::unique_ptr<Compliance> compliance_;
    const std::optional<FlowLaw> flow_;
    FrictionNewton newton_;
};

FrictionSolver::FrictionSolver(const FrictionBodies& bodies) : bodies_(bodies) {}
FrictionSolver::~FrictionSolver() = default;

void FrictionSolver::start(const FrictionTask& task, Observer& observer) {
    area_.reset();  // frees its memory for the next one
    area_ = std::make_unique<Area>(bodies_, task);
    const bool may_coarsen = !task.estimate_is_good && area_->elements() >= smallest_to_coarsen;
    if (!may_coarsen) return area_->start(task);
    if (any(task.estimate)) {
        area_->start(task);
        area_->newton().iterate(0, task.settings, observer);
        const double along = std::sqrt(static_cast<double>(area_->elements()));
        const double poor = task.forces ? poor_times_elements_for_forces : poor_times_elements;
        if (area_->newton().evidence().residual * along <= poor) return;
    }
    area_->start_on_coarser(task, observer);
}

FrictionSolution FrictionSolver::solve(const FrictionTask& task, Observer& observer) {
    const Stopwatch stopwatch;
    if (area_ && area_->stands(task.bound))
        area_->go_on(task);
    else
        start(task, observer);
    area_->newton().iterate(task.settings.max_iterations, task.settings, observer);
    FrictionSolution solution = area_->solution();
    solution.evidence.seconds = stopwatch.seconds();
    if (!solution.evidence.converged) area_.reset();  // Its data are useless.
    return solution;
}

Field FrictionSolver::first_tractions(const FrictionTask& task, Observer& observer) {
    start(task, observer);
    Field first = area_->tractions();
    area_.reset();
    return first;
}

void FrictionSolver::forget() {
    area_.reset();
}

}  // namespace contactd

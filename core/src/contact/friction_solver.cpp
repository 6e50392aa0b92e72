#include "friction_solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rolling/newton_solution.hpp"
#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr std::size_t smallest_to_coarsen = 1000;  // elements in contact
// From there on, a coarser grid gives a better start than an estimate whose residual is larger than this over the
// number of elements along the contact.
constexpr double poor_times_elements = 3;

}  // namespace

// What stays as long as the contact area does: its elements, operators on a box around them, and the iteration.
class FrictionSolver::Area {
   public:
    Area(const FrictionBodies& bodies, const FrictionTask& task)
        : size_(bodies.grid.size()),
          restriction_(bodies.influence,
                       bounding_box(extent_of(bodies.influence), [&](std::size_t i) { return task.bound[i] > 0; }),
                       false),
          change_(bodies.change == nullptr || restriction_.is_whole() ? nullptr
                                                                      : bodies.change->on(restriction_.box())),
          is_whole_(restriction_.is_whole() || (bodies.change != nullptr && !change_)),
          bodies_(is_whole_ ? bodies
                            : FrictionBodies{restriction_.influence(), change_.get(), restriction_.crop(bodies.grid),
                                             bodies.step_x, bodies.step_y}),
          contact_(crop(task.bound), crop(task.rigid.x), crop(task.rigid.y)),
          compliance_(compliance_of(bodies_, contact_)),
          newton_(*compliance_, contact_, task.forces) {}

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
        const FrictionStart start = contactd::start_on_coarser(bodies_, contact_, task.forces, task.uniform, observer);
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

   private:
    Values crop(std::span<const double> whole) const {
        return is_whole_ ? Values(whole.begin(), whole.end()) : restriction_.crop(whole);
    }

    const std::size_t size_;
    const Restriction restriction_;
    const std::shared_ptr<const StepOperator> change_;
    const bool is_whole_;
    const FrictionBodies bodies_;
    Contact contact_;
    const std::unique_ptr<Compliance> compliance_;
    FrictionNewton newton_;
};

FrictionSolver::FrictionSolver(const FrictionBodies& bodies) : bodies_(bodies) {}
FrictionSolver::~FrictionSolver() = default;

FrictionSolution FrictionSolver::solve(const FrictionTask& task, Observer& observer) {
    area_.reset();  // gives its memory to the next one
    area_ = std::make_unique<Area>(bodies_, task);
    const bool may_coarsen = area_->elements() >= smallest_to_coarsen;
    bool is_poor = !any(task.estimate);
    if (!is_poor || !may_coarsen) area_->start(task);
    if (!is_poor && may_coarsen) {
        area_->newton().iterate(0, task.settings, observer);
        const double along = std::sqrt(static_cast<double>(area_->elements()));
        is_poor = area_->newton().evidence().residual * along > poor_times_elements;
    }
    if (is_poor && may_coarsen) area_->start_on_coarser(task, observer);
    return finish(task, observer);
}

FrictionSolution FrictionSolver::solve_again(const FrictionTask& task, Observer& observer) {
    if (area_ && area_->stands(task.bound)) {
        area_->go_on(task);
    } else {
        area_.reset();
        area_ = std::make_unique<Area>(bodies_, task);
        area_->start(task);
    }
    return finish(task, observer);
}

FrictionSolution FrictionSolver::finish(const FrictionTask& task, Observer& observer) {
    const Stopwatch stopwatch;
    area_->newton().iterate(task.settings.max_iterations, task.settings, observer);
    FrictionSolution solution = area_->solution();
    solution.evidence.seconds = stopwatch.seconds();
    if (!solution.evidence.converged) area_.reset();  // what it has learnt is of no use
    return solution;
}

}  // namespace contactd

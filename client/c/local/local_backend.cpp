// Contacts in process: what a session of the daemon does, without the daemon. Half-spaces in closed form, and tables
// that are given; there is no builder here.
#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "backend.hpp"
#include "contactd/closed_form_record.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/status.hpp"
#include "contactd/version.hpp"

namespace contactd::c {
namespace {

/// Ends a solve at its deadline, or when a stop is requested.
class LocalObserver final : public Observer {
   public:
    LocalObserver(const Control& control, std::chrono::milliseconds timeout)
        : stop_(control.stop), timeout_(timeout), deadline_(Clock::now() + timeout) {}
    bool cancelled() const override { return stop_.stop_requested() || Clock::now() >= deadline_; }

    [[noreturn]] void explain() const {
        if (stop_.stop_requested())
            throw StatusError(StatusCode::cancelled, reason::request_cancelled, "The call was stopped.");
        throw StatusError(StatusCode::deadline_exceeded, reason::deadline_passed,
                          "The step was not solved within " + std::to_string(timeout_.count()) + " ms.");
    }

   private:
    using Clock = std::chrono::steady_clock;
    std::stop_token stop_;
    std::chrono::milliseconds timeout_;
    Clock::time_point deadline_;
};

BodyTable table_of(const ContactSetup& setup, const Body& body, std::optional<IcUse>& use) {
    const Grid& grid = setup.grid;
    if (const GivenIcs* given = body.given()) {
        use = IcUse{"given", ic_key(*given), {}};
        use->evidence.source = "table";
        use->evidence.version = "contactd " + version();
        return cropped(given->table, grid.nx, grid.ny);
    }
    const Ics* ics = body.computed();
    if (ics == nullptr) return IcTable(grid.nx, grid.ny);
    if (ics->source == IcSource::fem)
        throw StatusError(StatusCode::unimplemented, "NO_BUILDER",
                          "Tables by finite elements are made by a daemon; open a connection to one.");
    const IcSpec spec{*ics, body.material, grid.dx, grid.dy, grid.nx, grid.ny};
    const IcRecord record = closed_form_record(spec);
    use = IcUse{"closed_form", ic_key(spec), record.evidence};
    return body_table(record, spec);
}

StatusError not_converged() {
    return {StatusCode::aborted, reason::not_converged,
            "The step did not converge, and the contact stays where it was: take a smaller step, or start the contact "
            "with other settings or so that unconverged steps count."};
}

/// Where a contact is: all that a step leaves to the next one.
struct State {
    long long step = 0;
    SurfaceState tractions;
    std::optional<Motion> motion;
};

class LocalContact final : public OpenContact {
   public:
    LocalContact(const SessionSpec& spec, const Settings& settings)
        : opened_{spec.setup, spec.load},
          accept_unconverged_(spec.accept_unconverged),
          timeout_(settings.timeout),
          state_{0, spec.load.previous, {}} {
        fit_influence(opened_);
    }

    StepReply step(const StepInput& input, const Control& control) override {
        const ContactProblem problem = stated(input);
        fit_influence(problem);
        LocalObserver observer(control, control.timeout.value_or(timeout_));
        StepReply reply{state_.step + 1, solved(problem, observer)};
        ContactSolution& solution = reply.solution;
        if (!solution.converged() && !accept_unconverged_) throw not_converged();
        state_ = {reply.step, {solution.pressure, solution.traction_x, solution.traction_y}, solution.motion};
        keep_wanted(input.fields, solution);
        return reply;
    }

    std::string save(const Control&) override {
        const std::string name = "state-" + std::to_string(++serial_);
        states_.emplace(name, state_);
        return name;
    }
    void restore(const std::string& state, const Control&) override { state_ = states_.at(state); }
    void forget(const std::string& state, const Control&) override { states_.erase(state); }
    void close(const Control&) override {}
    const IcUses& ics() const override { return ics_; }

   private:
    ContactSolution solved(const ContactProblem& problem, LocalObserver& observer) const {
        try {
            return solve_contact(problem, influence_, observer);
        } catch (const Cancelled&) {
            observer.explain();
        }
    }

    /// What the step says over what the contact was opened with, from where the step before ended.
    ContactProblem stated(const StepInput& input) const {
        ContactProblem problem = opened_;
        if (input.approach || input.Fn) {
            problem.approach = input.approach;
            problem.Fn = input.Fn;
        }
        if (input.gap) problem.gap = input.gap;
        if (input.friction) problem.friction = input.friction;
        if (!input.rigid_slip.empty()) problem.rigid_slip = input.rigid_slip;
        if (input.motion)
            problem.motion = *input.motion;
        else
            take_estimates(problem);
        if (problem.model == Model::full) problem.previous = problem.initial = state_.tractions;
        return problem;
    }

    void take_estimates(ContactProblem& problem) const {
        const auto* before = state_.motion ? std::get_if<Rolling>(&*state_.motion) : nullptr;
        auto* rolling = std::get_if<Rolling>(&problem.motion);
        if (before == nullptr || rolling == nullptr || !problem.friction) return;
        if (before->force.Fx && rolling->force.Fx) rolling->xi = before->xi;
        if (before->force.Fy && rolling->force.Fy) rolling->eta = before->eta;
    }

    /// Operators of rolling are made for the way of a step.
    void fit_influence(const ContactProblem& problem) {
        if (problem.model != Model::full) return;
        const auto way = step_of(problem);
        if (influence_.here && (way == rolling_step_ || way == std::array<double, 2>{})) return;
        if (problem.bodies.pair) {
            ics_.pair = IcUse{"given", ic_key(*problem.bodies.pair), {}};
            influence_ = make_influence(problem, problem.bodies.pair->table);
        } else {
            BodyTable upper = table_of(problem, problem.bodies.upper, ics_.upper);
            influence_ = make_influence(problem, std::move(upper), table_of(problem, problem.bodies.lower, ics_.lower));
        }
        rolling_step_ = way;
    }

    static void keep_wanted(const std::vector<SolutionField>& fields, ContactSolution& solution) {
        const auto unwanted = [&](SolutionField field) { return std::ranges::find(fields, field) == fields.end(); };
        if (unwanted(SolutionField::element_division)) solution.element_division.clear();
        if (unwanted(SolutionField::pressure)) solution.pressure.clear();
        if (unwanted(SolutionField::traction_x)) solution.traction_x.clear();
        if (unwanted(SolutionField::traction_y)) solution.traction_y.clear();
        if (unwanted(SolutionField::slip_x)) solution.slip_x.clear();
        if (unwanted(SolutionField::slip_y)) solution.slip_y.clear();
    }

    const ContactProblem opened_;
    const bool accept_unconverged_;
    const std::chrono::milliseconds timeout_;
    State state_;
    std::map<std::string, State> states_;
    long long serial_ = 0;
    IcUses ics_;
    ContactInfluence influence_;
    std::array<double, 2> rolling_step_{};  // that influence_ is for
};

class LocalBackend final : public Backend {
   public:
    std::unique_ptr<OpenContact> open(const SessionSpec& spec, const Settings& settings,
                                      const Control&) const override {
        return std::make_unique<LocalContact>(spec, settings);
    }
    void ping(const Settings&) const override {}
};

}  // namespace

std::unique_ptr<Backend> make_local_backend() {
    return std::make_unique<LocalBackend>();
}

bool has_local_backend() {
    return true;
}

}  // namespace contactd::c

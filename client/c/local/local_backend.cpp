// Solves contacts in process, with the engine of the daemon.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

#include "backend.hpp"
#include "contactd/fields/grid_arrays.hpp"
#include "contactd/status.hpp"
#include "contactd/strip_frames.hpp"
#include "engine/engine.hpp"
#include "engine/environment.hpp"
#include "engine/ics/problem_tables.hpp"
#include "helping_threads.hpp"
#include "wheel_cache.hpp"

namespace contactd::c {
namespace {

using engine::ContactSteps;
using engine::Engine;
using engine::StepState;
using StepStatePtr = std::shared_ptr<const StepState>;

/// Reports the progress of a call, and ends it at its deadline or on a stop request.
class LocalObserver final : public Observer {
   public:
    LocalObserver(const Control& control, std::chrono::milliseconds timeout)
        : control_(control), timeout_(timeout), deadline_(Clock::now() + timeout) {}

    void on_progress(const Progress& progress) override {
        if (control_.on_progress) control_.on_progress(std::string(progress.stage), progress.fraction);
    }
    bool cancelled() const override { return control_.stop.stop_requested() || Clock::now() >= deadline_; }

    [[noreturn]] void explain() const {
        if (control_.stop.stop_requested())
            throw StatusError(StatusCode::cancelled, reason::request_cancelled, "The call was stopped.");
        throw StatusError(StatusCode::deadline_exceeded, reason::deadline_passed,
                          "The call did not finish within " + std::to_string(timeout_.count()) + " ms.");
    }

   private:
    using Clock = std::chrono::steady_clock;
    const Control& control_;
    const std::chrono::milliseconds timeout_;
    const Clock::time_point deadline_;
};

/// Returns the result of `act`; a failure states the reason of its end.
template <class Act>
auto observed(const Control& control, std::chrono::milliseconds timeout, const Act& act) {
    LocalObserver observer(control, control.timeout.value_or(timeout));
    try {
        return act(observer);
    } catch (const Cancelled&) {
        observer.explain();
    }
}

void keep_requested(const SolutionFields& fields, ContactSolution& solution) {
    for (const SolutionField field : all_solution_fields) {
        if (std::ranges::find(fields, field) != fields.end()) continue;
        if (field == SolutionField::element_division)
            solution.element_division.clear();
        else
            (solution.*solution_arrays[static_cast<std::size_t>(field)]).clear();
    }
}

/// Holds the current and the previous state of a contact or a wheel.
class LocalHistory {
   public:
    explicit LocalHistory(StepState start = {}) : here_{std::make_shared<const StepState>(std::move(start)), nullptr} {}

    /// Returns the initial state of a step. A repeated step that was solved is undone.
    StepStatePtr start_of(bool again) {
        const StepStatePtr from = again && here_.before && asked_ == here_.last->step ? here_.before : here_.last;
        asked_ = from->step + 1;
        return from;
    }
    long long asked() const { return asked_; }
    void went_on(const StepStatePtr& from, StepState to) {
        here_ = {std::make_shared<const StepState>(std::move(to)), from};
    }

    std::string save() {
        const std::string name = "state-" + std::to_string(++serial_);
        saved_.emplace(name, here_);
        return name;
    }
    void restore(const std::string& state) {
        here_ = saved_.at(state);
        asked_ = here_.last->step;
    }
    void forget(const std::string& state) { saved_.erase(state); }

   private:
    /// Holds the current state, and the initial state of the step that led to it.
    struct Place {
        StepStatePtr last, before;
    };
    Place here_;
    long long asked_ = 0;  // the number of the last step requested
    std::map<std::string, Place> saved_;
    long long serial_ = 0;
};

class LocalContact final : public OpenContact {
   public:
    LocalContact(std::shared_ptr<Engine> engine, std::unique_ptr<ContactSteps> steps, std::chrono::milliseconds timeout)
        : engine_(std::move(engine)),
          steps_(std::move(steps)),
          timeout_(timeout),
          ics_(engine::uses_of(steps_->opened, steps_->ics())),
          history_(steps_->start()) {}

    StepReply step(const StepInput& input, const Control& control) override {
        const StepStatePtr from = history_.start_of(input.again);
        ContactSolution solution = observed(control, timeout_, [&](LocalObserver& observer) {
            const auto overlay = [&](const std::optional<Motion>& last, ContactProblem& problem) {
                engine::overlay(input, last, problem);
            };
            return engine_->solve(*steps_, *from, overlay, observer);
        });
        StepReply reply{history_.asked(), solution};
        history_.went_on(from, ContactSteps::after(*from, std::move(solution)));
        keep_requested(input.fields, reply.solution);
        return reply;
    }

    std::string save(const Control&) override { return history_.save(); }
    void restore(const std::string& state, const Control&) override { history_.restore(state); }
    void forget(const std::string& state, const Control&) override { history_.forget(state); }
    void close(const Control&) override {}
    const IcUses& ics() const override { return ics_; }

   private:
    const std::shared_ptr<Engine> engine_;
    const std::unique_ptr<ContactSteps> steps_;
    const std::chrono::milliseconds timeout_;
    const IcUses ics_;
    LocalHistory history_;
};

class LocalWheel final : public OpenWheel {
   public:
    LocalWheel(std::shared_ptr<Engine> engine, std::chrono::milliseconds timeout)
        : engine_(std::move(engine)), timeout_(timeout) {}

    bool goes_on_with(const WheelRailSetup& setup) const override { return steps_ && serves(steps_->setup(), setup); }
    WheelRailSolution solve(const WheelInput& input, const Control& control) override {
        if (!goes_on_with(input.setup)) open(input.setup);
        const WheelRailStepInput request = step_of(steps_->setup(), input);
        const StepStatePtr from = history_.start_of(input.again);
        StepState after;
        const auto begin = std::chrono::steady_clock::now();
        WheelRailSolution solution = observed(control, timeout_, [&](LocalObserver& observer) {
            return engine_->solve(*steps_, *from, request, after, observer);
        });
        history_.went_on(from, std::move(after));
        keep_requested(input, solution);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return solution;
    }
    /// Returns the duration of the last step.
    double seconds() const { return seconds_; }
    std::string save(const WheelRailSetup& setup, const Control&) override {
        if (!goes_on_with(setup)) open(setup);
        return history_.save();
    }
    void restore(const std::string& state, const Control&) override { history_.restore(state); }
    void forget(const std::string& state, const Control&) override { history_.forget(state); }
    WheelsetSolution solve_wheelset(const WheelsetInput& input, const Control& control) override {
        // Estimates are invalid after a failure.
        const bool goes_on = wheelset_ && *wheelset_ == input.setup;
        wheelset_.reset();
        if (!goes_on) wheelset_estimates_ = {};
        WheelsetSolution solution = observed(control, timeout_, [&](LocalObserver& observer) {
            return engine_->solve(input.setup, input.state, wheelset_estimates_, observer);
        });
        wheelset_ = input.setup;
        keep_requested(input, solution.right);
        keep_requested(input, solution.left);
        return solution;
    }

   private:
    void open(const WheelRailSetup& setup) {
        steps_ = engine_->open(WheelRailSessionSpec{setup, {}, true});
        history_ = LocalHistory();
    }
    template <class Input>
    static void keep_requested(const Input& input, WheelRailSolution& solution) {
        for (WheelRailPatch& patch : solution.patches) {
            c::keep_requested(input.fields, patch.solution);
            if (!input.gap) patch.gap.clear();
        }
    }

    const std::shared_ptr<Engine> engine_;
    const std::chrono::milliseconds timeout_;
    std::unique_ptr<engine::WheelRailSteps> steps_;
    LocalHistory history_;
    double seconds_ = 0;
    std::optional<WheelsetSetup> wheelset_;  // of the estimates
    WheelsetEstimates wheelset_estimates_;
};

WheelResult result_of(const WheelCall& call) {
    try {
        return call.wheel.solve(call.input, call.control);
    } catch (...) {
        return std::current_exception();
    }
}

class LocalBackend final : public Backend {
   public:
    std::unique_ptr<OpenContact> open(const SessionSpec& spec, const Settings& settings,
                                      const Control& control) const override {
        const auto timeout = may_build(spec.setup) ? settings.build_timeout : settings.timeout;
        auto steps = observed(control, timeout, [&](LocalObserver& observer) { return engine_->open(spec, observer); });
        return std::make_unique<LocalContact>(engine_, std::move(steps), settings.timeout);
    }
    std::vector<StripFrame> frames(const Section& section, int columns, double ds, const Settings&,
                                   const Control&) const override {
        const IcSpec spec = spec_of_frames(section, columns, ds);
        validate(spec);
        return strip_frames(spec);
    }
    std::unique_ptr<OpenWheel> open_wheel(const Settings& settings) const override {
        return std::make_unique<LocalWheel>(engine_, settings.timeout);
    }
    std::vector<WheelResult> solve_many(std::span<const WheelCall> calls, int threads) const override {
        std::vector<WheelResult> results(calls.size());
        // The slowest wheel starts first, so that it does not run alone at the end.
        std::vector<std::size_t> order(calls.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto expected = [&](std::size_t i) { return static_cast<const LocalWheel&>(calls[i].wheel).seconds(); };
        std::ranges::stable_sort(order, std::ranges::greater(), expected);
        const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
        helpers_.share(calls.size(), threads == 0 ? processors : static_cast<std::size_t>(threads),
                       [&](std::size_t i) { results[order[i]] = result_of(calls[order[i]]); });
        return results;
    }
    void ping(const Settings&) const override {}

   private:
    static bool may_build(const ContactSetup& setup) {
        if (!engine::needs_tables(setup)) return false;
        const auto specs = engine::specs_of(setup);
        return std::ranges::any_of(specs, [](const auto& spec) { return spec && spec->source == IcSource::fem; });
    }

    const std::shared_ptr<Engine> engine_ = std::make_shared<Engine>(engine::settings_of_environment());
    mutable HelpingThreads helpers_;
};

}  // namespace

std::unique_ptr<Backend> make_local_backend() {
    return std::make_unique<LocalBackend>();
}

bool has_local_backend() {
    return true;
}

}  // namespace contactd::c

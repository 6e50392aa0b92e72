// Measures the cost that layers, memory, temperature and models of virtual penetration add to a solve of steady
// rolling. The problem is the elliptic contact of the reference values on n x n elements, from zero. Counter
// over_plain is the median time of a solve over that of an alternating plain solve, by the same law of Coulomb without
// them. Row curve shows products per point of a creep curve.
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "contact_cases.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/solve_contact.hpp"

namespace {

using namespace contactd;
using bench::Values;

constexpr Material steel{82000, 0.28};

/// Returns a contact under 50 kN with semi-axes of about 6 x 4 mm, half of which slips.
ContactProblem rolling_problem(int n) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
    problem.bodies = {{steel}, {steel}};
    problem.gap = radii_of_force({6, 4}, (1 - steel.nu) / steel.G, 50000);
    problem.Fn = 50000;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = 0.002;
    rolling.eta = 0.001;
    rolling.phi = 1e-4;
    rolling.velocity = 20000;
    problem.motion = rolling;
    return problem;
}

KineticFriction falling(bool remembers) {
    KineticFriction kinetic{SlipLaw::exponential, 0.2, 100};
    if (remembers) kinetic.memory = FrictionMemory{0.02, 1};
    return kinetic;
}

using Change = void (*)(ContactProblem&);

void plain(ContactProblem&) {}
void elastic_layer(ContactProblem& problem) {
    problem.friction->layer = InterfacialLayer{2e-5};
}
void flow(ContactProblem& problem) {
    problem.friction->layer = InterfacialLayer{2e-5, 150};
}
void hardening(ContactProblem& problem) {
    problem.friction->layer = InterfacialLayer{2e-5, 100, 5000};
}
void falling_friction(ContactProblem& problem) {
    problem.friction->kinetic = falling(false);
}
void memory(ContactProblem& problem) {
    problem.friction->kinetic = falling(true);
}
void temperature(ContactProblem& problem) {
    problem.temperature = ThermalBodies{};
}
void friction_by_temperature(ContactProblem& problem) {
    problem.temperature = ThermalBodies{};
    problem.friction->temperature = TemperatureFriction{-0.1, 0, 200};
}
void layer_memory_temperature(ContactProblem& problem) {
    elastic_layer(problem);
    memory(problem);
    temperature(problem);
}
void hardening_and_memory(ContactProblem& problem) {
    hardening(problem);
    memory(problem);
}
void fastsim(ContactProblem& problem) {
    problem.model = Model::fastsim;
}
void kpec(ContactProblem& problem) {
    fastsim(problem);
    problem.normal_model = NormalModel::kpec;
}
void analyn(ContactProblem& problem) {
    fastsim(problem);
    problem.normal_model = NormalModel::analyn;
}
void by_approach(ContactProblem& problem) {
    problem.Fn.reset();
    problem.approach = 0.08;
}
void fastsim_by_approach(ContactProblem& problem) {
    fastsim(problem);
    by_approach(problem);
}
void kpec_by_approach(ContactProblem& problem) {
    kpec(problem);
    by_approach(problem);
}
void analyn_by_approach(ContactProblem& problem) {
    analyn(problem);
    by_approach(problem);
}

ContactInfluence influence_of(const ContactProblem& problem) {
    return make_influence(problem, bench::pair_table(problem.grid, steel));
}

void run(benchmark::State& state, Change change, Change without) {
    ContactProblem problem = rolling_problem(static_cast<int>(state.range(0))), reference = problem;
    change(problem);
    without(reference);
    const ContactInfluence influence = influence_of(problem);
    Observer observer;
    const auto seconds_of = [&](const ContactProblem& which) {
        const double start = bench::processor_seconds();
        benchmark::DoNotOptimize(solve_contact(which, influence, observer));
        return bench::processor_seconds() - start;
    };
    const ContactSolution solution = solve_contact(problem, influence, observer);  // makes boxes and plans
    seconds_of(reference);
    std::vector<double> with, plain_solves;
    for (auto _ : state) {
        with.push_back(seconds_of(problem));
        state.PauseTiming();
        plain_solves.push_back(seconds_of(reference));
        state.ResumeTiming();
    }
    state.counters["over_plain"] = bench::median(with) / bench::median(plain_solves);
    state.counters["solver_iterations"] =
        (solution.evidence.tangential ? *solution.evidence.tangential : solution.evidence.normal).iterations;
    if (!solution.converged()) state.SkipWithError("the solver did not converge");
}

void solve(benchmark::State& state, Change change) {
    run(state, change, plain);
}
void simplified(benchmark::State& state, Change change) {
    run(state, change, fastsim);
}
/// Measures without the search for the approach that produces the force.
void simplified_by_approach(benchmark::State& state, Change change) {
    run(state, change, fastsim_by_approach);
}

/// Counts the products of the operators that it wraps.
class CountedInfluence final : public InfluenceOperator {
   public:
    CountedInfluence(std::shared_ptr<const InfluenceOperator> inner, long& products)
        : inner_(std::move(inner)), products_(products) {}
    std::size_t size() const override { return inner_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override {
        ++products_;
        inner_->normal(pz, uz);
    }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        ++products_;
        inner_->tangential(px, py, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override { return inner_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        inner_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        inner_->precondition_tangential(rx, ry, zx, zy);
    }
    std::size_t bytes() const override { return inner_->bytes(); }

   private:
    std::shared_ptr<const InfluenceOperator> inner_;
    long& products_;
};

class CountedStep final : public StepOperator {
   public:
    CountedStep(std::shared_ptr<const StepOperator> inner, long& products)
        : inner_(std::move(inner)), products_(products) {}
    std::size_t size() const override { return inner_->size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        ++products_;
        inner_->tangential(px, py, ux, uy);
    }
    bool coupled() const override { return inner_->coupled(); }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        inner_->tangential_of_normal(pz, ux, uy);
    }
    std::size_t bytes() const override { return inner_->bytes(); }
    std::shared_ptr<const StepInverse> inverse(double added) const override { return inner_->inverse(added); }

   private:
    std::shared_ptr<const StepOperator> inner_;
    long& products_;
};

/// Solves for sixty creepages up to 1 %, each from the tractions of the previous one.
void curve(benchmark::State& state, Change change) {
    constexpr int points = 60;
    ContactProblem problem = rolling_problem(static_cast<int>(state.range(0)));
    change(problem);
    long products = 0;
    ContactInfluence influence = influence_of(problem);
    influence.current = std::make_shared<CountedInfluence>(influence.current, products);
    influence.increment = std::make_shared<CountedStep>(influence.increment, products);
    Observer observer;
    bool converged = true;
    for (auto _ : state) {
        products = 0;
        problem.initial = {};
        for (int k = 1; k <= points; ++k) {
            auto& rolling = std::get<Rolling>(problem.motion);
            rolling.xi = 0.01 * k / points;
            rolling.eta = rolling.phi = 0;
            ContactSolution solution = solve_contact(problem, influence, observer);
            converged = converged && solution.converged();
            problem.initial = {std::move(solution.pressure), std::move(solution.traction_x),
                               std::move(solution.traction_y)};
        }
    }
    state.counters["products_a_point"] = static_cast<double>(products) / points;
    if (!converged) state.SkipWithError("a point did not converge");
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMicrosecond);
}

BENCHMARK_CAPTURE(solve, plain, plain)->Apply(sizes);
BENCHMARK_CAPTURE(solve, elastic_layer, elastic_layer)->Apply(sizes);
BENCHMARK_CAPTURE(solve, flow, flow)->Apply(sizes);
BENCHMARK_CAPTURE(solve, hardening, hardening)->Apply(sizes);
BENCHMARK_CAPTURE(solve, falling_friction, falling_friction)->Apply(sizes);
BENCHMARK_CAPTURE(solve, memory, memory)->Apply(sizes);
BENCHMARK_CAPTURE(solve, temperature, temperature)->Apply(sizes);
BENCHMARK_CAPTURE(solve, friction_by_temperature, friction_by_temperature)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, kpec, kpec)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, analyn, analyn)->Apply(sizes);
BENCHMARK_CAPTURE(simplified_by_approach, kpec, kpec_by_approach)->Apply(sizes);
BENCHMARK_CAPTURE(simplified_by_approach, analyn, analyn_by_approach)->Apply(sizes);
BENCHMARK_CAPTURE(curve, plain, plain)->ArgName("n")->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curve, hardening_and_memory, hardening_and_memory)
    ->ArgName("n")
    ->Arg(25)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curve, layer_memory_temperature, layer_memory_temperature)
    ->ArgName("n")
    ->Arg(25)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

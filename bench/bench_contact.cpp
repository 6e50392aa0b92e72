// Measures whole contact problems, normal and tangential, as in a request: solve_contact with existing operators.
// Counter A_p is the time of the row in products A p (one scalar convolution), measured in the same run.
#include "contact_cases.hpp"
#include "contactd/contact_gradients.hpp"
#include "contactd/solve_contact.hpp"

namespace {

using namespace contactd;
using bench::Elliptic;

ContactProblem on_ellipse(int n, const Motion& motion) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
    problem.bodies = Bodies::of({Elliptic::steel, Elliptic::steel});
    problem.gap = radii_of_force({6, 4}, (1 - Elliptic::steel.nu) / Elliptic::steel.G, Elliptic::Fn);
    problem.Fn = Elliptic::Fn;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = motion;
    return problem;
}

Rolling rolling(double factor = 1) {
    Rolling motion;
    motion.xi = 0.002 * factor;
    motion.eta = 0.001 * factor;
    motion.phi = 1e-4 * factor;
    return motion;
}

Shift shift() {
    Shift motion;
    motion.rigid_shift.x = 0.01;
    motion.rigid_shift.y = 0.005;
    return motion;
}

void run(benchmark::State& state, const ContactProblem& problem) {
    Observer observer;
    const ContactInfluence influence = make_influence(problem, bench::pair_table(problem));
    bench::count_in_products(state, *influence.current,
                             [&] { return bench::evidence_of(solve_contact(problem, influence, observer)); });
}

// Measures the cost of derivatives; the row is the solve with them. Counters are their own cost, in products and
// relative to an alternating solve without them, and the number of their products.
void run_derivatives(benchmark::State& state, ContactProblem problem) {
    Observer observer;
    const ContactInfluence influence = make_influence(problem, bench::pair_table(problem));
    const ContactProblem plain = problem;
    problem.derivatives = true;
    ContactSolution solution = solve_contact(plain, influence, observer);
    std::vector<double> plain_seconds;
    bench::count_in_products(state, *influence.current, [&] {
        const double start = bench::processor_seconds();
        solve_contact(plain, influence, observer);
        plain_seconds.push_back(bench::processor_seconds() - start);
        return bench::evidence_of(solution);
    });
    const double product = bench::median(plain_seconds) / state.counters["A_p"];
    std::vector<double> seconds;
    for (std::size_t i = 0; i < plain_seconds.size(); ++i) {
        const double start = bench::processor_seconds();
        solution = solve_contact(problem, influence, observer);
        seconds.push_back(bench::processor_seconds() - start);
    }
    const double more = bench::median(seconds) - bench::median(plain_seconds);
    state.counters["derivatives_A_p"] = more / product;
    state.counters["of_the_solve"] = more / bench::median(plain_seconds);
    state.counters["derivatives_iterations"] = solution.evidence.derivatives->iterations;
}

// Measures gradients by all inputs; the row is the solve. Counters are the cost of one and of three outputs relative to
// alternating solves, in products, and the numbers of their iterations.
void run_gradients(benchmark::State& state, const ContactProblem& problem) {
    Observer observer;
    const ContactInfluence influence = make_influence(problem, bench::pair_table(problem));
    std::vector<Cotangents> outputs(3);
    outputs[0].Fx = outputs[1].Fy = outputs[2].Mz = 1;
    const std::vector<Cotangents> one(outputs.begin(), outputs.begin() + 1);
    const std::vector<GradientInput> by{GradientInput::gap, GradientInput::mu, GradientInput::rigid_slip};
    ContactSolution solution;
    std::vector<double> solve_seconds, one_seconds, three_seconds;
    ContactGradients of_one, of_three;
    bench::count_in_products(state, *influence.current, [&] {
        const double start = bench::processor_seconds();
        solution = solve_contact(problem, influence, observer);
        const double solved = bench::processor_seconds();
        of_one = contact_gradients(problem, influence, solution, one, by, observer);
        const double once = bench::processor_seconds();
        of_three = contact_gradients(problem, influence, solution, outputs, by, observer);
        solve_seconds.push_back(solved - start);
        one_seconds.push_back(once - solved);
        three_seconds.push_back(bench::processor_seconds() - once);
        return bench::evidence_of(solution);
    });
    const double solve = bench::median(solve_seconds);
    state.counters["one_of_the_solve"] = bench::median(one_seconds) / solve;
    state.counters["three_of_the_solve"] = bench::median(three_seconds) / solve;
    state.counters["one_iterations"] = of_one.evidence.iterations;
    state.counters["three_iterations"] = of_three.evidence.iterations;
}

// Measures pressures of viscoelastic bodies in rolling. Counters are their time over that of alternating runs of NORM
// on the same bodies without creep, and the iterations of both.
void run_creep(benchmark::State& state, const ContactProblem& problem) {
    Observer observer;
    ContactProblem elastic = problem;
    for (Body* body : {&elastic.bodies.upper, &elastic.bodies.lower}) body->viscoelastic.reset();
    const ContactInfluence influence = make_influence(problem, bench::pair_table(problem)),
                           of_elastic = make_influence(elastic, bench::pair_table(elastic));
    std::vector<double> seconds, elastic_seconds;
    SolverEvidence of_creep, of_norm;
    for ([[maybe_unused]] auto _ : state) {
        of_creep = solve_contact(problem, influence, observer).evidence.normal;
        of_norm = solve_contact(elastic, of_elastic, observer).evidence.normal;
        seconds.push_back(of_creep.seconds);
        elastic_seconds.push_back(of_norm.seconds);
    }
    state.counters["of_elastic"] = bench::median(seconds) / bench::median(elastic_seconds);
    state.counters["iterations"] = of_creep.iterations;
    state.counters["elastic_iterations"] = of_norm.iterations;
    state.counters["converged"] = of_creep.converged;
}

ContactSolution solved(const ContactProblem& problem) {
    Observer observer;
    const IcTable pair = bench::pair_table(problem.grid, problem.bodies.upper.material);
    return solve_contact(problem, make_influence(problem, pair), observer);
}

int size_of(const benchmark::State& state) {
    return static_cast<int>(state.range(0));
}

void normal_by_force(benchmark::State& state) {
    ContactProblem problem = on_ellipse(size_of(state), {});
    problem.friction.reset();
    run(state, problem);
}

void normal_of_bodies_that_creep(benchmark::State& state) {
    Rolling motion = rolling();
    motion.velocity = 1000;
    ContactProblem problem = on_ellipse(size_of(state), motion);
    problem.friction->mu = {0};
    // These parameters are near the maximum of the rolling resistance.
    for (Body* body : {&problem.bodies.upper, &problem.bodies.lower}) body->viscoelastic = Viscoelasticity{1, 6e-3};
    run_creep(state, problem);
}

void shift_problem(benchmark::State& state) {
    run(state, on_ellipse(size_of(state), shift()));
}

template <class M>
Motion by_force(M motion, double Fx, double Fy) {
    motion.force.Fx = Fx;
    motion.force.Fy = Fy;
    return motion;
}

void shift_by_force(benchmark::State& state) {
    run(state, on_ellipse(size_of(state), by_force(shift(), -8000, -3000)));
}

void steady_rolling(benchmark::State& state) {
    run(state, on_ellipse(size_of(state), rolling()));
}

// Uses creepages 5 % larger than those of the previous step, and starts from its pressures and tractions.
void steady_rolling_warm(benchmark::State& state) {
    ContactProblem problem = on_ellipse(size_of(state), rolling());
    const ContactSolution last = solved(problem);
    problem.initial.pressure = last.pressure;
    problem.initial.traction_x = last.traction_x;
    problem.initial.traction_y = last.traction_y;
    problem.motion = rolling(1.05);
    run(state, problem);
}

// Uses creepages 5 % larger than those of the steady state at the start of the step.
void transient_step(benchmark::State& state) {
    ContactProblem problem = on_ellipse(size_of(state), rolling());
    const ContactSolution last = solved(problem);
    problem.previous = {last.pressure, last.traction_x, last.traction_y};
    Rolling motion = rolling(1.05);
    motion.kind = RollingKind::transient;
    problem.motion = motion;
    run(state, problem);
}

// Solves ten steps from rest in one problem.
void transient_march(benchmark::State& state) {
    Rolling motion = rolling();
    motion.kind = RollingKind::transient;
    motion.steps = 10;
    run(state, on_ellipse(size_of(state), motion));
}

void steady_rolling_by_force(benchmark::State& state) {
    run(state, on_ellipse(size_of(state), by_force(rolling(), -8000, -6000)));
}

ContactProblem on_softer_body(int n, const Motion& motion) {
    ContactProblem problem = on_ellipse(n, motion);
    problem.bodies.lower.material = {41000, 0.1};
    return problem;
}

void shift_of_unlike_bodies(benchmark::State& state) {
    run(state, on_softer_body(size_of(state), shift()));
}

void shift_of_unlike_bodies_by_force(benchmark::State& state) {
    run(state, on_softer_body(size_of(state), by_force(shift(), -8000, -3000)));
}

void rolling_of_unlike_bodies(benchmark::State& state) {
    run(state, on_softer_body(size_of(state), rolling()));
}

void rolling_of_unlike_bodies_by_force(benchmark::State& state) {
    run(state, on_softer_body(size_of(state), by_force(rolling(), -8000, -6000)));
}

void derivatives_of_shift(benchmark::State& state) {
    run_derivatives(state, on_ellipse(size_of(state), shift()));
}

void derivatives_of_steady_rolling(benchmark::State& state) {
    run_derivatives(state, on_ellipse(size_of(state), rolling()));
}

void derivatives_of_transient_step(benchmark::State& state) {
    Rolling motion = rolling();
    motion.kind = RollingKind::transient;
    run_derivatives(state, on_ellipse(size_of(state), motion));
}

void derivatives_of_unlike_bodies_that_shift(benchmark::State& state) {
    run_derivatives(state, on_softer_body(size_of(state), shift()));
}

void derivatives_of_unlike_bodies_that_roll(benchmark::State& state) {
    run_derivatives(state, on_softer_body(size_of(state), rolling()));
}

void gradients_of_shift(benchmark::State& state) {
    run_gradients(state, on_ellipse(size_of(state), shift()));
}
void gradients_of_steady_rolling(benchmark::State& state) {
    run_gradients(state, on_ellipse(size_of(state), rolling()));
}
void gradients_of_unlike_bodies_that_roll(benchmark::State& state) {
    run_gradients(state, on_softer_body(size_of(state), rolling()));
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMicrosecond);
}
void more_sizes(benchmark::internal::Benchmark* rows) {
    sizes(rows);
    rows->Arg(200);
}

BENCHMARK(normal_by_force)->Apply(more_sizes);
BENCHMARK(normal_of_bodies_that_creep)->Apply(more_sizes);
BENCHMARK(shift_problem)->Apply(sizes);
BENCHMARK(shift_by_force)->Apply(sizes);
BENCHMARK(shift_of_unlike_bodies)->Apply(sizes);
BENCHMARK(shift_of_unlike_bodies_by_force)->Apply(sizes);
BENCHMARK(steady_rolling)->Apply(more_sizes);
BENCHMARK(steady_rolling_warm)->Apply(more_sizes);
BENCHMARK(transient_step)->Apply(sizes);
BENCHMARK(transient_march)->Apply(sizes);
BENCHMARK(steady_rolling_by_force)->Apply(sizes);
BENCHMARK(rolling_of_unlike_bodies)->Apply(sizes);
BENCHMARK(rolling_of_unlike_bodies_by_force)->Apply(sizes);
BENCHMARK(derivatives_of_shift)->Apply(sizes);
BENCHMARK(derivatives_of_steady_rolling)->Apply(sizes);
BENCHMARK(derivatives_of_transient_step)->Apply(sizes);
BENCHMARK(derivatives_of_unlike_bodies_that_shift)->Apply(sizes);
BENCHMARK(derivatives_of_unlike_bodies_that_roll)->Apply(sizes);
BENCHMARK(gradients_of_shift)->Apply(sizes);
BENCHMARK(gradients_of_steady_rolling)->Apply(sizes);
BENCHMARK(gradients_of_unlike_bodies_that_roll)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

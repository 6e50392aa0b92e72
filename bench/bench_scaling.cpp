// Measures the cost of each model against the number of elements, which docs/performance.png shows (./dev bench
// --plot). Counter elements is the number of elements of the grids. Counter A_p, of models that solve equations on
// half-spaces or layers, is the median time of a solve over that of a scalar product on the same grid.
#include "contact_cases.hpp"
#include "contactd/closed_form_record.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/solve_wheel_rail.hpp"

namespace {

using namespace contactd;
using bench::Elliptic;
using bench::Values;

constexpr double of_steel = (1 - Elliptic::steel.nu) / Elliptic::steel.G;

/// Presses bodies together with 50 kN, with semi-axes of 6 x 4 mm on n x n elements if this is their mean compliance.
ContactProblem on_ellipse(int n, double compliance = of_steel) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
    problem.bodies = Bodies::of({Elliptic::steel, Elliptic::steel});
    problem.gap = radii_of_force({6, 4}, compliance, Elliptic::Fn);
    problem.Fn = Elliptic::Fn;
    return problem;
}

ContactProblem rolling(int n, double compliance = of_steel) {
    ContactProblem problem = on_ellipse(n, compliance);
    problem.friction = FrictionLaw{{0.3}};
    Rolling motion;
    motion.xi = 0.002;
    motion.eta = 0.001;
    motion.phi = 1e-4;
    problem.motion = motion;
    return problem;
}

int size_of(const benchmark::State& state) {
    return static_cast<int>(state.range(0));
}

void count_elements(benchmark::State& state, std::size_t elements) {
    state.counters["elements"] = static_cast<double>(elements);
}

void run(benchmark::State& state, const ContactProblem& problem, const ContactInfluence& influence) {
    Observer observer;
    bench::count_in_products(state, *influence.current,
                             [&] { return bench::evidence_of(solve_contact(problem, influence, observer)); });
    count_elements(state, problem.grid.size());
}

void run_on_half_spaces(benchmark::State& state, const ContactProblem& problem) {
    run(state, problem, make_influence(problem, bench::pair_table(problem)));
}

void product(benchmark::State& state) {
    const int n = size_of(state);
    const Grid grid = Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
    const ConvolutionOperator influence(bench::pair_table(grid, Elliptic::steel), n, n);
    const Values p(influence.size(), 1.0);
    Values u(p.size());
    influence.normal(p, u);  // creates plans
    for (auto _ : state) influence.normal(p, u);
    count_elements(state, grid.size());
}

void normal(benchmark::State& state) {
    run_on_half_spaces(state, on_ellipse(size_of(state)));
}

void shift(benchmark::State& state) {
    ContactProblem problem = rolling(size_of(state));
    Shift motion;
    motion.rigid_shift.x = 0.01;
    motion.rigid_shift.y = 0.005;
    problem.motion = motion;
    run_on_half_spaces(state, problem);
}

void steady_rolling(benchmark::State& state) {
    run_on_half_spaces(state, rolling(size_of(state)));
}

void dissimilar(benchmark::State& state) {
    const Material soft{41000, 0.1};
    ContactProblem problem = rolling(size_of(state), 0.5 * (of_steel + (1 - soft.nu) / soft.G));
    problem.bodies.lower.material = soft;
    run_on_half_spaces(state, problem);
}

/// Both bodies have a coating of half their modulus, 1 mm thick.
void layered(benchmark::State& state) {
    ContactProblem problem = rolling(size_of(state), 1.2 * of_steel);
    const Body coated = Body::of(Layers{{{1, 41000, 0.28}}, Elliptic::steel});
    problem.bodies.upper = problem.bodies.lower = coated;
    const IcSpec spec{std::get<Ics>(coated.ics), coated.material, problem.grid.dx,
                      problem.grid.dy,           problem.grid.nx, problem.grid.ny};
    const BodyTable table = body_table(closed_form_record(dimensionless(spec)), spec);
    run(state, problem, make_influence(problem, table, table));
}

void simplified(benchmark::State& state, Model model, NormalModel normal = NormalModel::of_model) {
    ContactProblem problem = rolling(size_of(state));
    problem.model = model;
    problem.normal_model = normal;
    if (model == Model::hertz) std::get<Rolling>(problem.motion).phi = 0;
    Observer observer;
    const ContactInfluence none;
    benchmark::DoNotOptimize(solve_contact(problem, none, observer));
    for (auto _ : state) benchmark::DoNotOptimize(solve_contact(problem, none, observer));
    count_elements(state, problem.grid.size());
}

/// Solves S1002 on 60E1 at the gauge corner under 10 kN, with elements of 10/n mm, at its known height. The time
/// includes the geometry. No estimate is given.
void conformal(benchmark::State& state) {
    WheelRailSetup setup;
    setup.conformal = Conformal::rotated;
    setup.dx = setup.dy = 10.0 / size_of(state);
    const WheelRailContact contact(setup);
    WheelRailState wheel;
    wheel.position.y = 8;
    wheel.velocity.x = 30000;
    wheel.velocity.pitch = -30000 / 460.0;
    wheel.Fz = 10000;
    Observer observer;
    wheel.position.z = contact.solve(wheel, observer).z;
    wheel.Fz.reset();
    WheelRailSolution solution;
    for (auto _ : state) solution = contact.solve(wheel, observer);
    std::size_t elements = 0;
    for (const WheelRailPatch& patch : solution.patches) elements += patch.place.grid.size();
    count_elements(state, elements);
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Unit(benchmark::kMicrosecond);
    for (const int n : {10, 16, 25, 40, 64, 100, 160, 256, 400, 640, 1000}) rows->Arg(n);
}

/// A patch of a wheel on a rail has at most 200,000 elements.
void sizes_on_rails(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Unit(benchmark::kMicrosecond);
    for (const int n : {10, 16, 25, 40, 64, 100, 160, 256, 400, 600}) rows->Arg(n);
}

BENCHMARK(product)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, hertz, Model::hertz)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, fastsim, Model::fastsim)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, fastrip, Model::fastrip)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, polach, Model::polach)->Apply(sizes);
BENCHMARK_CAPTURE(simplified, kpec, Model::fastsim, NormalModel::kpec)->Apply(sizes);
BENCHMARK(normal)->Apply(sizes);
BENCHMARK(shift)->Apply(sizes);
BENCHMARK(steady_rolling)->Apply(sizes);
BENCHMARK(dissimilar)->Apply(sizes);
BENCHMARK(layered)->Apply(sizes);
BENCHMARK(conformal)->Apply(sizes_on_rails);

}  // namespace

BENCHMARK_MAIN();

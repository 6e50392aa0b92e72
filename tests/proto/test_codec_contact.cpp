#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <limits>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

Shift shift(double x, double y) {
    Shift shift;
    shift.rigid_shift = {x, y};
    return shift;
}

ContactProblem problem() {
    ContactProblem problem;
    problem.grid = Grid{3, 2, 0.1, 1.0 / 3, -7, 0.3};
    problem.bodies = {{200, 0.42}, {100.1, 0.3}};
    problem.gap = std::vector<double>{0.1, 0.2, 0.3, -0.4, 1.0 / 7, 6e-5};
    problem.approach = 0.02;
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = shift(0.00817, -1e-9);
    problem.rigid_slip = {{1e-3, 0, 0, 0, 0, 2}, {0, 0, 1.0 / 3, 0, 0, 0}};
    problem.previous = {{1, 0, 0, 0, 0, 2}, {}, {0, 0, 0.1 + 0.2, 0, 0, 0}};
    problem.settings.normal = {1e-9, 50};
    problem.settings.tangential = {1e-5, 70};
    problem.settings.outer = {1e-4, 7};
    problem.initial.traction_y = {1, 2, 3, 4, 5, 6};
    problem.derivatives = true;
    return problem;
}

json sent(const json& message) {
    return json::parse(dump(message));
}

/// Returns the received problem, sent with its arrays as frames.
ContactProblem arrived(const ContactProblem& original) {
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = sent(encode_problem(original, arrays));
    CAPTURE(params.dump());
    CHECK(violations_of("contact.solve.params", params).empty());
    return decode_problem(params, arrays.take_frames());
}

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refused_field(const json& params, const Frames& frames = {}) {
    REQUIRE(violations_of("contact.solve.params", params).empty());
    const auto status = wire::status_thrown_by([&] { decode_problem(params, frames); });
    REQUIRE(status);
    REQUIRE(status->violations.size() == 1);
    return status->violations[0].field;
}

}  // namespace

TEST_CASE("A problem comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const ContactProblem original = problem();
    ArrayWriter arrays(encoding);
    const json params = encode_problem(original, arrays);

    CHECK(violations_of("contact.solve.params", params).empty());
    const auto frames = arrays.take_frames();
    CHECK_NOTHROW(check_frames_used(params, frames));
    const ContactProblem read = decode_problem(sent(params), frames);

    CHECK(read.grid == original.grid);
    CHECK(read.bodies == original.bodies);
    CHECK(read.gap == original.gap);
    CHECK(read.approach == original.approach);
    CHECK_FALSE(read.Fn);
    CHECK(read.model == Model::full);
    CHECK(read.friction == original.friction);
    CHECK(read.motion == original.motion);
    CHECK(read.rigid_slip == original.rigid_slip);
    CHECK(read.previous == original.previous);
    CHECK(read.settings.normal == original.settings.normal);
    CHECK(read.settings.tangential == original.settings.tangential);
    CHECK(read.settings.outer == original.settings.outer);
    CHECK(read.initial.pressure.empty());
    CHECK(read.initial.traction_x.empty());
    CHECK(read.initial.traction_y == original.initial.traction_y);
    CHECK(read.derivatives);
}

TEST_CASE("Curved columns come back exactly, and what a request leaves out of them has its default", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    ContactProblem original = problem();
    original.columns = ContactColumns{{}, -0.3, {1.5, -2}};
    for (int iy = 0; iy < original.grid.ny; ++iy) original.columns->frames.push_back({0.1 * iy, 1.0 / 3, 0.7 - iy});
    ArrayWriter arrays(encoding);
    json params = encode_problem(original, arrays);
    CHECK(violations_of("contact.solve.params", params).empty());
    const auto frames = arrays.take_frames();
    CHECK(decode_problem(sent(params), frames).columns == original.columns);
    params["columns"].erase("direction");
    params["columns"].erase("origin");
    const ContactColumns read = *decode_problem(sent(params), frames).columns;
    CHECK(read.direction == 0);
    CHECK(read.origin == SectionPoint{});
    params.erase("columns");
    CHECK_FALSE(decode_problem(sent(params), frames).columns);
}

TEST_CASE("Regions come back exactly", "[codec]") {
    ContactProblem original = problem();
    original.regions = ContactRegions{{{{-3, -1}, {-2, 1.0 / 3}}, {{1, 3}, {-2, 2}}}, {1, 0.4, 0.4, 1}};
    ArrayWriter arrays(ArrayEncoding::frame);
    json params = encode_problem(original, arrays);
    CHECK(violations_of("contact.solve.params", params).empty());
    CHECK(decode_problem(sent(params), arrays.take_frames()).regions == original.regions);
}

TEST_CASE("A problem with finite-element coefficients keeps their spec", "[codec]") {
    ContactProblem original = problem();
    Ics ics;
    ics.source = IcSource::fem;
    ics.body = BodyShape::block;
    ics.load_shape = LoadShape::bilinear;
    ics.any_nu = true;
    ics.fem = *fem_preset("paper-mesh2-test1");
    original.bodies = Bodies::of(original.bodies.materials(), ics);
    original.friction.reset();
    ArrayWriter arrays(ArrayEncoding::list);

    const ContactProblem read = decode_problem(sent(encode_problem(original, arrays)), {});

    CHECK(read.bodies == original.bodies);
    CHECK_FALSE(read.friction);
}

TEST_CASE("A problem may ask for an accuracy", "[codec]") {
    json params = wire::solve_params();
    params["ics"] = {{"source", "fem"}, {"body", "block"}, {"L_over_h", 20}, {"accuracy", 1e-2}};
    REQUIRE(violations_of("contact.solve.params", params).empty());

    const ContactProblem read = decode_problem(params, {});
    ArrayWriter arrays(ArrayEncoding::list);
    const ContactProblem again = decode_problem(sent(encode_problem(read, arrays)), {});

    for (const ContactProblem& problem : {read, again}) {
        const Ics& ics = *problem.bodies.upper.computed();
        CHECK(ics.accuracy == 1e-2);
        CHECK(ics.body == BodyShape::block);
        CHECK(ics.fem.L_over_h == 20);
        CHECK_FALSE(ics.any_nu);
    }
}

TEST_CASE("What a request leaves out has its default", "[codec]") {
    const ContactProblem read = decode_problem(wire::solve_params(), {});

    CHECK(read.grid == Grid::of_elements(3, 2, 0.06, 0.06));
    CHECK(read.bodies.lower == read.bodies.upper);
    CHECK(read.settings.normal == ContactProblem{}.settings.normal);
    CHECK(read.settings.tangential == ContactProblem{}.settings.tangential);
    CHECK(read.settings.outer == ContactProblem{}.settings.outer);
    CHECK(read.gap == Gap{Paraboloid{50, 50}});
    CHECK(read.model == Model::full);
    CHECK(read.friction == FrictionLaw{{0.4}});
    CHECK(read.motion == Motion{shift(0.00817, 0)});
    CHECK(read.rigid_slip.empty());
    CHECK(read.previous.empty());
}

TEST_CASE("The schema tells the defaults of the solvers as they are", "[codec]") {
    const ContactProblem defaults;
    const json& solvers = schema("contact.solve.params")["properties"]["settings"]["properties"];
    const auto settings_of = [&](const char* solver) {
        const json& fields = solvers[solver]["properties"];
        return SolverSettings{fields["tolerance"]["default"].get<double>(),
                              fields["max_iterations"]["default"].get<int>()};
    };
    CHECK(settings_of("normal") == defaults.settings.normal);
    CHECK(settings_of("tangential") == defaults.settings.tangential);
    CHECK(settings_of("outer") == defaults.settings.outer);
}

TEST_CASE("A radius left out is a flat direction, one corner may be given", "[codec]") {
    json params = wire::solve_params();
    params["gap"] = {{"paraboloid", {{"Ry", -10}}}};
    params["grid"]["x0"] = 100;

    const ContactProblem read = decode_problem(params, {});

    CHECK(read.grid.x0 == 100);
    CHECK(read.grid.y0 == Grid::of_elements(3, 2, 0.06, 0.06).y0);
    CHECK(read.gap == Gap{Paraboloid{infinity, -10}});
}

TEST_CASE("A grid that is too large is refused before it is allocated", "[codec]") {
    json params = wire::solve_params();
    params["grid"]["nx"] = params["grid"]["ny"] = 1'000'000;
    CHECK(refused_field(params) == "grid.nx");
}

TEST_CASE("Arrays of a problem that do not fit are named", "[codec]") {
    json params = wire::solve_params();
    params["gap"] = {{"array", {{1, 2, 3}}}};
    CHECK(refused_field(params) == "gap.array");

    params = wire::solve_params();
    params["initial"]["traction_x"] = json::parse(R"({"$array": {"frame": 2, "dtype": "<f8", "shape": [2, 3]}})");
    CHECK(refused_field(params, {"short"}) == "initial.traction_x");
    CHECK(refused_field(params, {"", "short"}) == "initial.traction_x");

    params = wire::solve_params();
    params["friction"]["mu"] = {{0.1, 0.2}};
    CHECK(refused_field(params) == "friction.mu");

    params = wire::solve_params();
    params["previous"]["pressure"] = {{1, 2, 3}, {4, 5, "6"}};
    CHECK(refused_field(params) == "previous.pressure");
}

TEST_CASE("Every way to state gap and load comes back", "[codec]") {
    ContactProblem original = problem();
    SECTION("paraboloid") {
        original.gap = GENERATE(Paraboloid{50, 1.0 / 3}, Paraboloid{infinity, -7}, Paraboloid{1e12, infinity});
    }
    SECTION("semi-axes") {
        original.gap = SemiAxes{0.1 + 0.2, 7};
    }
    SECTION("force") {
        original.Fn = 1.0 / 7;
        original.approach.reset();
    }
    const ContactProblem read = arrived(original);
    CHECK(read.gap == original.gap);
    CHECK(read.Fn == original.Fn);
    CHECK(read.approach == original.approach);
}

TEST_CASE("A paraboloid flatter than the wire takes arrives as an array", "[codec]") {
    ContactProblem original = problem();
    const Paraboloid paraboloid = GENERATE(Paraboloid{infinity, infinity}, Paraboloid{50, 1e13});
    original.gap = paraboloid;
    CHECK(arrived(original).gap == Gap{sampled(paraboloid, original.grid)});
}

TEST_CASE("A rigid body stays rigid", "[codec]") {
    ContactProblem original = problem();
    SECTION("upper") {
        original.bodies.upper = {Material::rigid()};
    }
    SECTION("lower") {
        original.bodies.lower = {Material::rigid()};
    }
    CHECK(arrived(original).bodies == original.bodies);
}

TEST_CASE("A simplified model needs bodies and no coefficients", "[codec]") {
    ContactProblem original = problem();
    original.model = GENERATE(Model::hertz, Model::fastsim, Model::fastrip, Model::polach);
    original.gap = SemiAxes{1, 2};
    const ContactProblem read = arrived(original);
    CHECK(read.model == original.model);
    CHECK(read.bodies == original.bodies);

    json params = wire::solve_params();
    params["model"] = "hertz";
    params["ics"] = {{"source", "table"}, {"table", {1}}, {"dx", 0.06}, {"dy", 0.06}};
    REQUIRE(violations_of("contact.solve.params", params).empty());
    CHECK_FALSE(decode_problem(params, {}).bodies.pair);
}

TEST_CASE("Every friction comes back exactly", "[codec]") {
    ContactProblem original = problem();
    FrictionLaw& friction = *original.friction;
    SECTION("coefficient per element") {
        friction.mu = {0.1, 0.2, 0.3, 0.4, 0, 1.0 / 3};
    }
    SECTION("kinetic") {
        friction.kinetic = {GENERATE(SlipLaw::linear, SlipLaw::exponential), 0.1, 1.0 / 7};
    }
    SECTION("shift") {
        Shift shift{{1e-3, -2e-3}, 1.0 / 3, {}, 0.25};
        SECTION("prescribed") {}
        SECTION("one force") {
            shift.force.Fy = -1.0 / 3;
        }
        SECTION("two forces") {
            shift.force.Fx = 0;
            shift.force.Fy = 1e-300;
        }
        original.motion = shift;
    }
    SECTION("rolling") {
        Rolling rolling;
        SECTION("with every default") {}
        SECTION("with every field") {
            rolling = {1e-3, -2e-3, 3e-4, 1.0 / 3, 0.1, 0.1 + 0.2, RollingKind::transient, 77, 3e4, {5.5, {}}};
        }
        original.motion = rolling;
    }
    const ContactProblem read = arrived(original);
    CHECK(read.friction == original.friction);
    CHECK(read.motion == original.motion);
}

TEST_CASE("What a friction leaves out has its default", "[codec]") {
    json params = wire::solve_params();
    const auto friction_of = [&](const char* text) {
        params["friction"] = json::parse(text);
        CHECK(violations_of("contact.solve.params", params).empty());
        return decode_problem(params, {});
    };
    Shift pulled;
    pulled.force.Fx = -3;
    CHECK(friction_of(R"({"mu": 0.3, "force": [-3, null]})").friction == FrictionLaw{{0.3}});
    CHECK(friction_of(R"({"mu": 0.3, "force": [-3, null]})").motion == Motion{pulled});
    CHECK(friction_of(R"({"mu": 0.3, "rolling": {}})").motion == Motion{Rolling{}});
    const KineticFriction kinetic{SlipLaw::exponential, 0.2, 5};
    CHECK(friction_of(R"({"mu": 0.3, "kinetic": {"mu": 0.2, "slip_velocity": 5}, "rolling": {}})").friction->kinetic ==
          kinetic);
}

TEST_CASE("Bodies with coefficients of their own keep them", "[codec]") {
    ContactProblem original = problem();
    Ics block;
    block.source = IcSource::fem;
    block.body = BodyShape::block;
    block.accuracy = 1e-2;
    SECTION("of different sources") {
        original.bodies.upper.ics = block;
    }
    SECTION("of different sources, the materials equal") {
        original.bodies.lower = original.bodies.upper;
        original.bodies.lower.ics = block;
    }
    SECTION("a table against a material") {
        GivenIcs given{IcTable(3, 2), original.grid.dx, original.grid.dy};
        for (const Axis i : {Axis::x, Axis::y, Axis::z}) given.table(i, i, 0, 0) = 1e-3;
        original.bodies.lower.ics = given;
    }
    SECTION("against a rigid body") {
        original.bodies = {{Material::rigid()}, {{200, 0.3}, block}};
    }
    CHECK(arrived(original).bodies == original.bodies);
}

TEST_CASE("Coefficients are said by a body, or for both", "[codec]") {
    json params = wire::solve_params();
    params.erase("ics");
    params["bodies"]["upper"]["ics"] = {{"source", "analytic"}, {"load_shape", "bilinear"}};
    SECTION("the lower body is as the upper one") {
        params["bodies"].erase("lower");
        REQUIRE(violations_of("contact.solve.params", params).empty());
        const ContactProblem read = decode_problem(params, {});
        CHECK(read.bodies.lower == read.bodies.upper);
        CHECK(read.bodies.lower.computed()->load_shape == LoadShape::bilinear);
    }
    SECTION("what a body does not say is said beside the bodies") {
        params["bodies"]["lower"] = {{"G", 1}, {"nu", 0.1}};
        CHECK(refused_field(params) == "bodies.lower.ics");
        params["ics"] = {{"source", "fem"}};
        REQUIRE(violations_of("contact.solve.params", params).empty());
        const ContactProblem read = decode_problem(params, {});
        CHECK(read.bodies.upper.computed()->source == IcSource::analytic);
        CHECK(read.bodies.lower.computed()->source == IcSource::fem);
    }
    SECTION("a table of the pair leaves nothing to say") {
        params["ics"] = {{"source", "table"}, {"table", {1}}, {"dx", 0.06}, {"dy", 0.06}};
        CHECK(refused_field(params) == "ics.table");
    }
    SECTION("a rigid body has none") {
        params["bodies"]["lower"] = {{"rigid", true}, {"ics", {{"source", "analytic"}}}};
        CHECK_FALSE(violations_of("contact.solve.params", params).empty());
    }
}

TEST_CASE("Bodies of layers are sent and received unchanged", "[codec]") {
    const Layers rubber{{{2, 1, 0.5}}, Material::rigid()};
    const Layers coated{{{0.01, 120000, 0.25}, {0.5, 3e4, 1.0 / 3}}, {82000, 0.28}};
    ContactProblem original = problem();
    original.bodies.lower = Body::of(rubber);
    CHECK(arrived(original).bodies == original.bodies);
    original.bodies.upper = Body::of(coated);
    CHECK(arrived(original).bodies == original.bodies);
    original.bodies = {Body::of(coated, LoadShape::bilinear), {Material::rigid()}};
    CHECK(arrived(original).bodies == original.bodies);
}

TEST_CASE("Layers that stand for both bodies are refused, since they have materials of their own", "[codec]") {
    const json layered{{"source", "analytic"},
                       {"body", "layered"},
                       {"layers", {{{"thickness", 2}, {"G", 1}, {"nu", 0.5}}}},
                       {"base", {{"rigid", true}}}};
    const json params{{"grid", {{"nx", 2}, {"ny", 2}, {"dx", 1}, {"dy", 1}}},
                      {"bodies", {{"upper", {{"G", 200}, {"nu", 0.3}}}}},
                      {"ics", layered},
                      {"gap", {{"paraboloid", {{"Rx", 10}}}}},
                      {"Fn", 1}};
    CHECK(refused_field(params) == "ics.body");
}

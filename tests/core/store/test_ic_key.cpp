#include <catch2/catch_test_macros.hpp>

#include "ic_records.hpp"

using namespace contactd;

TEST_CASE("The key is the same for every shear modulus, element size and extent") {
    const IcSpec spec = fem_spec(10, 10);
    IcSpec other = fem_spec(7, 9);
    other.material.G = 200;
    other.dx = other.dy = 0.1 * 3;
    other.fem.max_iterations = 99;

    CHECK(ic_key(other) == ic_key(spec));
    CHECK(ic_key(spec).size() == 64);
}

TEST_CASE("The key depends on everything that changes the numbers") {
    const std::string key = ic_key(fem_spec(10, 10));
    const auto changed = [&](auto change) {
        IcSpec spec = fem_spec(10, 10);
        change(spec);
        return ic_key(spec) != key;
    };

    CHECK(changed([](IcSpec& s) { s.material.nu = 0.3; }));
    CHECK(changed([](IcSpec& s) { s.dy = 0.4; }));
    CHECK(changed([](IcSpec& s) { s.source = IcSource::analytic; }));
    CHECK(changed([](IcSpec& s) { s.fem.order = 1; }));
    CHECK(changed([](IcSpec& s) { s.fem.L_over_h = 641; }));
    CHECK(changed([](IcSpec& s) { s.fem.l_over_h = 2; }));
    CHECK(changed([](IcSpec& s) { s.fem.h_over_hs = 8; }));
    CHECK(changed([](IcSpec& s) { s.fem.f = 1.3; }));
    CHECK(changed([](IcSpec& s) { s.fem.sampling = Sampling::linear; }));
    CHECK(changed([](IcSpec& s) { s.fem.tolerance = 1e-9; }));
    CHECK(changed([](IcSpec& s) { s.fem.strength_threshold = 0.6; }));
    CHECK(changed([](IcSpec& s) { s.fem.strength_threshold = 0; }));
    CHECK(changed([](IcSpec& s) { s.body = BodyShape::block; }));
    CHECK(changed([](IcSpec& s) { s.load_shape = LoadShape::bilinear; }));
    CHECK(changed([](IcSpec& s) { s.accuracy = 1e-3; }));
    CHECK(changed([](IcSpec& s) { s.any_nu = true; }));
    CHECK(changed([](IcSpec& s) { s.fem.t1_over_hs = 1; }));
    CHECK(changed([](IcSpec& s) { s.fem.far_boundary = FarBoundary::clamped; }));
    CHECK(changed([](IcSpec& s) { s.fem.solver = Solver::amg_pcg; }));
    CHECK(changed([](IcSpec& s) { s.fem.solver = Solver::direct; }));
    CHECK(changed([](IcSpec& s) { s.fem.stopping_criterion = StoppingCriterion::update; }));
    CHECK(changed([](IcSpec& s) { s.fem.mesh = MeshKind::prism; }));
}

TEST_CASE("The key depends on what a kind of mesh alone knows, for that kind only") {
    const auto key_of = [](MeshKind mesh, auto change) {
        IcSpec spec = fem_spec(10, 10);
        spec.fem.mesh = mesh;
        change(spec.fem);
        return ic_key(spec);
    };
    const auto nothing = [](FemSpec&) {};
    const auto turn = [](FemSpec& fem) { fem.diagonal = Diagonal::across; };
    const auto bound = [](FemSpec& fem) { fem.max_dofs = 2000; };

    CHECK(key_of(MeshKind::prism, turn) != key_of(MeshKind::prism, nothing));
    CHECK(key_of(MeshKind::hex, turn) == key_of(MeshKind::hex, nothing));
    CHECK(key_of(MeshKind::adaptive, bound) != key_of(MeshKind::adaptive, nothing));
    CHECK(key_of(MeshKind::hex, bound) == key_of(MeshKind::hex, nothing));
    const auto shape = [](FemSpec& fem) {
        fem.l_over_h = 2.5;
        fem.h_over_hs = 8;
        fem.f = 1.5;
        fem.t1_over_hs = 1;
    };
    CHECK(key_of(MeshKind::adaptive, shape) == key_of(MeshKind::adaptive, nothing));
    CHECK(key_of(MeshKind::prism, shape) != key_of(MeshKind::prism, nothing));
}

TEST_CASE("The key of a direct solve knows nothing of iterations") {
    IcSpec spec = fem_spec(10, 10), other = spec;
    spec.fem.solver = other.fem.solver = Solver::direct;
    other.fem.stopping_criterion = StoppingCriterion::update;
    other.fem.strength_threshold = 0.5;
    CHECK(ic_key(other) == ic_key(spec));
}

TEST_CASE("The key of an accuracy knows nothing of a mesh, and of a block its size") {
    IcSpec spec = fem_spec(10, 10);
    spec.accuracy = 1e-3;
    IcSpec other = spec;
    other.accuracy = 5e-3;  // the lower level serves it
    other.fem.order = 4;
    other.fem.L_over_h = 20;
    CHECK(ic_key(other) == ic_key(spec));

    spec.body = other.body = BodyShape::block;
    CHECK(ic_key(other) != ic_key(spec));
    other.fem.L_over_h = spec.fem.L_over_h;
    CHECK(ic_key(other) == ic_key(spec));
    other.accuracy = 1e-4;
    CHECK(ic_key(other) != ic_key(spec));
}

TEST_CASE("The key of a family is the same for every Poisson's ratio") {
    IcSpec spec = fem_spec(10, 10), other = spec;
    spec.any_nu = other.any_nu = true;
    other.material.nu = 0.42;
    CHECK(ic_key(other) == ic_key(spec));
}

TEST_CASE("The key of layers is the same for every unit, and depends on each layer and the base") {
    const auto key_of = [](const Layers& layers, double dx) {
        IcSpec spec;
        spec.body = BodyShape::layered;
        spec.layered = layers;
        spec.material = layers.surface();
        spec.dx = spec.dy = dx;
        spec.nx = spec.ny = 4;
        return ic_key(spec);
    };
    const Layers layers{{{0.3, 2, 0.5}, {1, 40, 0.2}}, {8, 0.3}};
    const std::string key = key_of(layers, 0.1);
    CHECK(key_of({{{0.6, 10, 0.5}, {2, 200, 0.2}}, {40, 0.3}}, 0.2) == key);
    CHECK(key_of(layers, 0.2) != key);
    CHECK(key_of({{{0.3, 2, 0.5}, {1, 40, 0.2}}, Material::rigid()}, 0.1) != key);
    CHECK(key_of({{{0.3, 2, 0.5}, {1, 40, 0.2}}, {8, 0.31}}, 0.1) != key);
    CHECK(key_of({{{0.3, 2, 0.5}, {1, 41, 0.2}}, {8, 0.3}}, 0.1) != key);
    CHECK(key_of({{{0.3, 2, 0.49}, {1, 40, 0.2}}, {8, 0.3}}, 0.1) != key);
    CHECK(key_of({{{1, 40, 0.2}, {0.3, 2, 0.5}}, {8, 0.3}}, 0.1) != key);
    CHECK(key_of({{{0.3, 2, 0.5}}, {8, 0.3}}, 0.1) != key);
}

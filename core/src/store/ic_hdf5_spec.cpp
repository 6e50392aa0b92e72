// Group `spec`: what a table is.
#include "hdf5_attributes.hpp"
#include "ic_hdf5_parts.hpp"

namespace contactd {

void write_fem(H5::Group& group, const FemSpec& fem) {
    put(group, "mesh", name_of(fem.mesh));
    put(group, "order", static_cast<long long>(fem.order));
    put(group, "l_over_h", fem.l_over_h);
    put(group, "h_over_hs", fem.h_over_hs);
    put(group, "f", fem.f);
    put(group, "t1_over_hs", fem.t1_over_hs);
    put(group, "L_over_h", fem.L_over_h);
    put(group, "diagonal", name_of(fem.diagonal));
    put(group, "max_dofs", fem.max_dofs);
    put(group, "far_boundary", name_of(fem.far_boundary));
    put(group, "sampling", name_of(fem.sampling));
    put(group, "solver", name_of(fem.solver));
    put(group, "stop_test", name_of(fem.stop_test));
    put(group, "tolerance", fem.tolerance);
    put(group, "max_iterations", static_cast<long long>(fem.max_iterations));
    if (fem.strength_threshold) put(group, "strength_threshold", *fem.strength_threshold);
}

FemSpec read_fem(const H5::Group& group) {
    FemSpec fem;
    fem.mesh = named<MeshKind>(group, "mesh");
    fem.order = integer(group, "order");
    fem.l_over_h = number(group, "l_over_h");
    fem.h_over_hs = number(group, "h_over_hs");
    fem.f = number(group, "f");
    fem.t1_over_hs = number(group, "t1_over_hs");
    fem.L_over_h = number(group, "L_over_h");
    fem.diagonal = named<Diagonal>(group, "diagonal");
    fem.max_dofs = long_integer(group, "max_dofs");
    fem.far_boundary = named<FarBoundary>(group, "far_boundary");
    fem.sampling = named<Sampling>(group, "sampling");
    fem.solver = named<Solver>(group, "solver");
    fem.stop_test = named<StopTest>(group, "stop_test");
    fem.tolerance = number(group, "tolerance");
    fem.max_iterations = integer(group, "max_iterations");
    if (group.attrExists("strength_threshold")) fem.strength_threshold = number(group, "strength_threshold");
    return fem;
}

void write_spec(H5::Group group, const IcSpec& spec) {
    put(group, "body", name_of(spec.body));
    put(group, "source", name_of(spec.source));
    put(group, "load_shape", name_of(spec.load_shape));
    put(group, "dy_over_dx", spec.dy / spec.dx);
    if (!is_dimensionless(spec)) {
        put(group, "dx", spec.dx);
        put(group, "dy", spec.dy);
        put(group, "G", spec.material.G);
    }
    put(group, "any_nu", static_cast<long long>(spec.any_nu));
    if (!spec.any_nu) put(group, "nu", spec.material.nu);
    if (spec.accuracy != 0) {
        put(group, "accuracy", spec.accuracy);
        if (spec.body == BodyShape::block) put(group, "L_over_h", spec.fem.L_over_h);
    } else if (spec.source == IcSource::fem) {
        write_fem(group, spec.fem);
    }
}

IcSpec read_spec(const H5::Group& group) {
    IcSpec spec;
    const bool has_dimensions = group.attrExists("dx");
    spec.dx = has_dimensions ? number(group, "dx") : 1;
    spec.dy = number(group, has_dimensions ? "dy" : "dy_over_dx");
    spec.body = named<BodyShape>(group, "body");
    spec.source = named<IcSource>(group, "source");
    spec.load_shape = named<LoadShape>(group, "load_shape");
    spec.any_nu = integer(group, "any_nu") != 0;
    spec.material = {has_dimensions ? number(group, "G") : 1, spec.any_nu ? 0 : number(group, "nu")};
    if (group.attrExists("accuracy")) {
        spec.accuracy = number(group, "accuracy");
        spec.fem.L_over_h = spec.body == BodyShape::block ? number(group, "L_over_h") : 0;
    } else if (spec.source == IcSource::fem) {
        spec.fem = read_fem(group);
    }
    return spec;
}

}  // namespace contactd

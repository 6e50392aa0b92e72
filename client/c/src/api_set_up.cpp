// contactd.h: the set-up of a contact.
#include "bodies_said.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::Body;
using contactd::Grid;
using contactd::Ics;
using contactd::Material;

namespace {

contactd::SolverSettings& settings_of(Said& said, std::int32_t solver) {
    word(solver, CONTACTD_OUTER, "solver");
    contactd::ContactSettings& settings = said.problem.settings;
    if (solver == CONTACTD_NORMAL) return settings.normal;
    return solver == CONTACTD_TANGENTIAL ? settings.tangential : settings.outer;
}

contactd::LoadShape load_shape_of(std::int32_t value) {
    return static_cast<contactd::LoadShape>(word(value, CONTACTD_BILINEAR, "ics.load_shape"));
}

}  // namespace

std::int32_t contactd_set_grid(contactd_contact* contact, std::int32_t nx, std::int32_t ny, double dx, double dy,
                               double x0, double y0) {
    return set_up(contact, "grid", [&](Said& said) {
        const Grid grid{nx, ny, dx, dy, x0, y0};
        validate(grid, "grid");
        said.problem.grid = grid;
    });
}

std::int32_t contactd_set_grid_centred(contactd_contact* contact, std::int32_t nx, std::int32_t ny, double dx,
                                       double dy) {
    return set_up(contact, "grid", [&](Said& said) {
        const Grid grid = Grid::centred(nx, ny, dx, dy);
        validate(grid, "grid");
        said.problem.grid = grid;
    });
}

std::int32_t contactd_set_material(contactd_contact* contact, std::int32_t body, double G, double nu) {
    return set_up(contact, "material", [&](Said& said) {
        const Material material{finite(G, "G"), finite(nu, "nu")};
        each_body(said, body, [&](Body& changed) {
            if (changed.layered() != nullptr) changed.ics = Ics{};  // which were the layers'
            changed.material = material;
        });
    });
}

std::int32_t contactd_set_rigid(contactd_contact* contact, std::int32_t body) {
    return set_up(contact, "material", [&](Said& said) {
        each_body(said, body, [](Body& changed) { changed.material = Material::rigid(); });
    });
}

std::int32_t contactd_set_half_space(contactd_contact* contact, std::int32_t body, std::int32_t load_shape) {
    return set_up(contact, "coefficients", [&](Said& said) {
        Ics ics;
        ics.load_shape = load_shape_of(load_shape);
        set_coefficients(said, body, ics);
    });
}

std::int32_t contactd_set_fem(contactd_contact* contact, std::int32_t body, std::int32_t shape, std::int32_t load_shape,
                              double accuracy, double L_over_h) {
    return set_up(contact, "coefficients", [&](Said& said) {
        Ics ics;
        ics.source = contactd::IcSource::fem;
        ics.body = static_cast<contactd::BodyShape>(word(shape, CONTACTD_BLOCK, "ics.body"));
        ics.load_shape = load_shape_of(load_shape);
        ics.accuracy = accuracy;
        if (!(accuracy >= contactd::finest_accuracy && accuracy <= contactd::coarsest_accuracy))
            throw contactd::InvalidArgument("ics.accuracy", "must lie in [1e-4, 0.1]");
        if (finite(L_over_h, "ics.L_over_h") != 0) ics.fem.L_over_h = L_over_h;
        set_coefficients(said, body, ics);
    });
}

std::int32_t contactd_set_table(contactd_contact* contact, std::int32_t body, std::int32_t nx, std::int32_t ny,
                                double dx, double dy, const double* values, std::int32_t count) {
    return set_up(contact, "coefficients", [&](Said& said) {
        word(body, CONTACTD_PAIR, "body");
        const std::vector<double> copied = array(values, count, "table");
        if (nx < 1 || ny < 1 || copied.size() != 9 * static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny))
            throw contactd::InvalidArgument("count", "is " + std::to_string(count) + "; it must be 9*nx*ny");
        contactd::GivenIcs given{{}, finite(dx, "ics.dx"), finite(dy, "ics.dy")};
        given.table.nx = nx;
        given.table.ny = ny;
        given.table.values.assign(copied.begin(), copied.end());
        if (body == CONTACTD_PAIR)
            said.problem.bodies.pair = std::move(given);
        else
            set_coefficients(said, body, given);
    });
}

std::int32_t contactd_set_line_contact(contactd_contact* contact, double datum) {
    return set_up(contact, "coefficients", [&](Said& said) {
        Ics ics;
        ics.line_contact = contactd::LineContactSpec{finite(datum, "ics.line_contact.datum")};
        set_coefficients(said, CONTACTD_BOTH, ics);
    });
}

std::int32_t contactd_set_layers(contactd_contact* contact, std::int32_t body, std::int32_t load_shape,
                                 const double* thickness, const double* G, const double* nu, std::int32_t count,
                                 double base_G, double base_nu) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const auto thicknesses = array(thickness, count, "ics.layers.thickness");
        const auto moduli = array(G, count, "ics.layers.G"), ratios = array(nu, count, "ics.layers.nu");
        contactd::Layers layers{{}, Material::rigid()};
        for (std::size_t i = 0; i < moduli.size(); ++i) layers.layers.push_back({thicknesses[i], moduli[i], ratios[i]});
        if (finite(base_G, "ics.base.G") != 0) layers.base = {base_G, finite(base_nu, "ics.base.nu")};
        if (layers.layers.empty()) throw contactd::InvalidArgument("count", "is 0; it must be at least 1");
        const Body layered = Body::of(layers, load_shape_of(load_shape));
        each_body(said, body, [&](Body& changed) { changed = layered; });
        said.problem.bodies.pair.reset();
    });
}

std::int32_t contactd_set_model(contactd_contact* contact, std::int32_t model) {
    return set_up(contact, "model", [&](Said& said) {
        said.problem.model = static_cast<contactd::Model>(word(model, CONTACTD_FASTSIM, "model"));
    });
}

std::int32_t contactd_set_tolerance(contactd_contact* contact, std::int32_t solver, double tolerance,
                                    std::int32_t max_iterations) {
    return set_up(contact, "tolerance",
                  [&](Said& said) { settings_of(said, solver) = {finite(tolerance, "tolerance"), max_iterations}; });
}

std::int32_t contactd_set_accept_unconverged(contactd_contact* contact, std::int32_t accept) {
    return set_up(contact, "tolerance", [&](Said& said) { said.accept_unconverged = word(accept, 1, "accept") != 0; });
}

std::int32_t contactd_set_previous(contactd_contact* contact, const double* pressure, const double* traction_x,
                                   const double* traction_y, std::int32_t count) {
    return set_up(contact, "history", [&](Said& said) {
        said.problem.previous = {array(pressure, count, "previous.pressure"),
                                 array(traction_x, count, "previous.traction_x"),
                                 array(traction_y, count, "previous.traction_y")};
    });
}

std::int32_t contactd_set_lease(contactd_contact* contact, double seconds) {
    return set_up(contact, "lease", [&](Said& said) {
        if (!(finite(seconds, "lease_seconds") > 0))
            throw contactd::InvalidArgument("lease_seconds", "must be positive");
        said.lease_seconds = seconds;
    });
}

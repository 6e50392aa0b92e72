// contactd.h: the set-up of a wheel on its rail.
#include <array>

#include "contactd/read_profile.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::ProfileKind;
using contactd::ProfilePoints;
using contactd::ProfileShape;
using contactd::WheelRailSetup;

namespace {

/// `change` may throw before it has changed anything.
template <class Change>
std::int32_t setup(contactd_wheel* wheel, const Change& change) {
    return with(wheel, [&](Wheel& changed) { change(changed.said.setup); });
}

bool is_wheel(std::int32_t body) {
    return word(body, CONTACTD_RAIL, "body") == CONTACTD_WHEEL;
}

/// Sets the profile of a body to what `make` gives, told where it will stand.
template <class Make>
std::int32_t set_profile(contactd_wheel* wheel, std::int32_t body, const Make& make) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        const bool of_wheel = is_wheel(body);
        ProfileShape shape = make(std::string(of_wheel ? "setup.wheel" : "setup.rail"));
        (of_wheel ? changed.wheel : changed.rail).shape = std::move(shape);
    });
}

double named(double value, const std::string& field) {
    return finite(value, field.c_str());
}

contactd::Body& body_of(WheelRailSetup& setup, std::int32_t body) {
    return is_wheel(body) ? setup.bodies.lower : setup.bodies.upper;
}

contactd::WheelRailFriction& friction_of(WheelRailSetup& setup) {
    if (!setup.friction) setup.friction.emplace();
    return *setup.friction;
}

contactd::SolverSettings& settings_of(WheelRailSetup& setup, std::int32_t solver) {
    switch (word(solver, CONTACTD_FORCE, "solver")) {
        case CONTACTD_NORMAL:
            return setup.settings.normal;
        case CONTACTD_TANGENTIAL:
            return setup.settings.tangential;
        case CONTACTD_OUTER:
            return setup.settings.outer;
        default:
            return setup.force;
    }
}

}  // namespace

std::int32_t contactd_wheel_set_side(contactd_wheel* wheel, std::int32_t side) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.side = static_cast<contactd::Side>(word(side, CONTACTD_RIGHT, "setup.side"));
    });
}

std::int32_t contactd_wheel_set_s1002(contactd_wheel* wheel) {
    return setup(wheel, [](WheelRailSetup& changed) { changed.wheel.shape = contactd::S1002{}; });
}

std::int32_t contactd_wheel_set_rail_60e1(contactd_wheel* wheel, double inclination) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.rail.shape = contactd::Rail60E1{finite(inclination, "setup.rail.rail_60e1.inclination")};
    });
}

std::int32_t contactd_wheel_set_arc(contactd_wheel* wheel, std::int32_t body, double radius, double slope, double from,
                                    double to) {
    return set_profile(wheel, body, [&](const std::string& field) {
        return contactd::ArcProfile{named(radius, field + ".arc.radius"), named(slope, field + ".arc.slope"),
                                    named(from, field + ".arc.ends"), named(to, field + ".arc.ends")};
    });
}

std::int32_t contactd_wheel_set_cone(contactd_wheel* wheel, std::int32_t body, double slope, double from, double to) {
    return set_profile(wheel, body, [&](const std::string& field) {
        return contactd::ConeProfile{named(slope, field + ".cone.slope"), named(from, field + ".cone.ends"),
                                     named(to, field + ".cone.ends")};
    });
}

std::int32_t contactd_wheel_set_points(contactd_wheel* wheel, std::int32_t body, const double* y, const double* z,
                                       std::int32_t count, double smoothing_length) {
    return set_profile(wheel, body, [&](const std::string& field) {
        const std::vector<double> across = array(y, count, "y"), down = array(z, count, "z");
        ProfilePoints points;
        for (std::size_t i = 0; i < across.size(); ++i)
            points.points.push_back({named(across[i], field + ".points"), named(down[i], field + ".points")});
        points.smoothing_length = named(smoothing_length, field + ".smoothing_length");
        return points;
    });
}

std::int32_t contactd_wheel_set_file(contactd_wheel* wheel, std::int32_t body, const char* path,
                                     double smoothing_length) {
    return set_profile(wheel, body, [&](const std::string& field) {
        const auto kind = is_wheel(body) ? ProfileKind::wheel : ProfileKind::rail;
        ProfileShape shape = contactd::read_profile(std::filesystem::path(given(path, "path")), kind).shape;
        std::get<ProfilePoints>(shape).smoothing_length = named(smoothing_length, field + ".smoothing_length");
        return shape;
    });
}

std::int32_t contactd_wheel_add_slice(contactd_wheel* wheel, double x) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.rail_slices.push_back({finite(x, "setup.rail_slices.x"), changed.rail});
    });
}

std::int32_t contactd_wheel_clear_slices(contactd_wheel* wheel) {
    return setup(wheel, [](WheelRailSetup& changed) { changed.rail_slices.clear(); });
}

std::int32_t contactd_wheel_add_wheel_slice(contactd_wheel* wheel, double angle) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.wheel_slices.push_back({finite(angle, "setup.wheel_slices.angle"), changed.wheel});
    });
}

std::int32_t contactd_wheel_clear_wheel_slices(contactd_wheel* wheel) {
    return setup(wheel, [](WheelRailSetup& changed) { changed.wheel_slices.clear(); });
}

std::int32_t contactd_wheel_set_track(contactd_wheel* wheel, double gauge, double gauge_height, double cant) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        contactd::Track track = changed.track;  // roller and springs stay
        track.gauge = finite(gauge, "setup.track.gauge");
        track.gauge_height = finite(gauge_height, "setup.track.gauge_height");
        track.cant = finite(cant, "setup.track.cant");
        track.rail_origin.reset();
        changed.track = track;
    });
}

std::int32_t contactd_wheel_set_rail_origin(contactd_wheel* wheel, double y, double z) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.track.rail_origin =
            contactd::ProfilePoint{finite(y, "setup.track.rail_origin.y"), finite(z, "setup.track.rail_origin.z")};
    });
}

std::int32_t contactd_wheel_set_roller(contactd_wheel* wheel, double radius) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.track.roller_radius = finite(radius, "setup.track.roller_radius");
        if (radius == 0) changed.track.roller_radius.reset();
    });
}

std::int32_t contactd_wheel_set_wheelset(contactd_wheel* wheel, double flange_back_distance,
                                         double flange_back_position, double nominal_radius) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.wheelset = {finite(flange_back_distance, "setup.wheelset.flange_back_distance"),
                            finite(flange_back_position, "setup.wheelset.flange_back_position"),
                            finite(nominal_radius, "setup.wheelset.nominal_radius")};
    });
}

std::int32_t contactd_wheel_set_material(contactd_wheel* wheel, std::int32_t body, double G, double nu) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        body_of(changed, body).material = contactd::Material{finite(G, "G"), finite(nu, "nu")};
    });
}

std::int32_t contactd_wheel_set_rigid(contactd_wheel* wheel, std::int32_t body) {
    return setup(wheel,
                 [&](WheelRailSetup& changed) { body_of(changed, body).material = contactd::Material::rigid(); });
}

std::int32_t contactd_wheel_set_model(contactd_wheel* wheel, std::int32_t model) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.model = static_cast<contactd::Model>(word(model, CONTACTD_FASTSIM, "setup.model"));
    });
}

std::int32_t contactd_wheel_set_mu(contactd_wheel* wheel, double mu) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        finite(mu, "setup.friction.mu");
        contactd::WheelRailFriction& friction = friction_of(changed);
        friction.mu = {{0, mu}};
        friction.along_profile = false;
    });
}

std::int32_t contactd_wheel_set_mu_by_angle(contactd_wheel* wheel, const double* angle, const double* mu,
                                            std::int32_t count, std::int32_t along_profile) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        const std::vector<double> angles = array(angle, count, "angle"), values = array(mu, count, "mu");
        std::vector<contactd::FrictionAtAngle> entries;
        for (std::size_t i = 0; i < angles.size(); ++i)
            entries.push_back({finite(angles[i], "setup.friction.mu"), finite(values[i], "setup.friction.mu")});
        contactd::WheelRailFriction& friction = friction_of(changed);
        friction.mu = std::move(entries);
        friction.along_profile = along_profile != 0;
    });
}

std::int32_t contactd_wheel_set_kinetic(contactd_wheel* wheel, std::int32_t law, double mu, double slip_velocity) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        const contactd::KineticFriction kinetic{
            static_cast<contactd::SlipLaw>(word(law, CONTACTD_EXPONENTIAL, "setup.friction.kinetic.law")),
            finite(mu, "setup.friction.kinetic.mu"), finite(slip_velocity, "setup.friction.kinetic.slip_velocity")};
        friction_of(changed).kinetic = kinetic;
    });
}

std::int32_t contactd_wheel_set_frictionless(contactd_wheel* wheel) {
    return setup(wheel, [](WheelRailSetup& changed) { changed.friction.reset(); });
}

std::int32_t contactd_wheel_set_elements(contactd_wheel* wheel, double dx, double dy, double dq) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        finite(dx, "setup.dx"), finite(dy, "setup.dy"), finite(dq, "setup.dq");
        changed.dx = dx;
        changed.dy = dy;
        changed.dq = dq;
    });
}

std::int32_t contactd_wheel_set_patch_rules(contactd_wheel* wheel, double angle_separate, double distance_separate,
                                            double distance_combine, double distance_turn, double locus_step) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        contactd::PatchRules rules = changed.patches;
        rules.angle_separate = finite(angle_separate, "setup.patches.angle_separate");
        rules.distance_separate = finite(distance_separate, "setup.patches.distance_separate");
        rules.distance_combine = finite(distance_combine, "setup.patches.distance_combine");
        rules.distance_turn = finite(distance_turn, "setup.patches.distance_turn");
        rules.locus_step = finite(locus_step, "setup.patches.locus_step");
        changed.patches = rules;
    });
}

std::int32_t contactd_wheel_set_bilinear(contactd_wheel* wheel, std::int32_t bilinear) {
    using contactd::WheelSurfaceKind;
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.wheel_surface = bilinear != 0 ? WheelSurfaceKind::bilinear : WheelSurfaceKind::exact;
    });
}

std::int32_t contactd_wheel_set_slip_of_surfaces(contactd_wheel* wheel, std::int32_t of_surfaces) {
    using contactd::RigidSlipKind;
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.rigid_slip = of_surfaces != 0 ? RigidSlipKind::surfaces : RigidSlipKind::plane;
    });
}

std::int32_t contactd_wheel_set_mesh_search(contactd_wheel* wheel, std::int32_t mesh) {
    using contactd::ContactSearch;
    return setup(wheel, [&](WheelRailSetup& changed) {
        changed.patches.search = mesh != 0 ? ContactSearch::mesh : ContactSearch::locus;
    });
}

std::int32_t contactd_wheel_set_conformal(contactd_wheel* wheel, std::int32_t conformal) {
    using contactd::Conformal;
    constexpr std::array kinds{Conformal::off, Conformal::half_space, Conformal::rotated, Conformal::fem,
                               Conformal::automatic};
    return setup(wheel, [&](WheelRailSetup& changed) {
        const std::int32_t last = static_cast<std::int32_t>(kinds.size()) - 1;
        changed.conformal = kinds.at(static_cast<std::size_t>(word(conformal, last, "conformal")));
    });
}

std::int32_t contactd_wheel_set_tolerance(contactd_wheel* wheel, std::int32_t solver, double tolerance,
                                          std::int32_t max_iterations) {
    return setup(wheel, [&](WheelRailSetup& changed) {
        settings_of(changed, solver) = {finite(tolerance, "tolerance"), max_iterations};
    });
}

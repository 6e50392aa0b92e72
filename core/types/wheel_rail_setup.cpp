#include "contactd/wheel_rail_setup.hpp"

#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/uniform_elements.hpp"
#include "fatigue/contact_fatigue_check.hpp"
#include "number_text.hpp"
#include "wear/contact_wear_check.hpp"

namespace contactd {
namespace {

constexpr double softest_spring = 1e-3, stiffest_spring = 1e10;  // N/mm

void require(bool right, const std::string& field, double value, const std::string& must) {
    if (!right) throw InvalidArgument(field, "is " + number_text(value) + "; it must " + must);
}

void check(const Track& track) {
    require(track.gauge_height <= 0 || track.gauge_height >= 1, "track.gauge_height", track.gauge_height,
            "be zero or at least 1 mm. Gauges are measured about 14 mm below the top of the rail; check the unit");
    if (track.roller_leans && !track.roller_radius)
        throw InvalidArgument("track.roller_leans",
                              "is given, but the rail is not a roller; give track.roller_radius, or remove it");
    if (!track.springs) return;
    const auto& [y, z] = *track.springs;
    if (!y && !z) throw InvalidArgument("track.springs", "has neither y nor z; remove it if the rail is rigid");
    for (const auto& [spring, field] : {std::pair(y, "track.springs.y"), std::pair(z, "track.springs.z")})
        if (spring) {
            require(
                *spring > 0 && *spring <= stiffest_spring, field, *spring,
                "be positive and at most " + number_text(stiffest_spring) + " N/mm; remove it if the rail is rigid");
            require(*spring >= softest_spring, field, *spring,
                    "be at least " + number_text(softest_spring) + " N/mm; rails on sleepers have 1e4 to 1e6");
        }
}

void check(const Wheelset& wheelset) {
    require(wheelset.flange_back_distance / 2 > wheelset.flange_back_position, "wheelset.flange_back_position",
            wheelset.flange_back_position,
            "be less than half the flange_back_distance, so that the wheel stays on its side of the axle");
}

void check_profile(const ProfileSpec& profile, ProfileKind kind, const std::string& field) {
    if (profile.kind != kind)
        throw InvalidArgument(
            field + ".kind", "is " + std::string(name_of(profile.kind)) + "; it must be " + std::string(name_of(kind)));
    renaming(in_place_of("profile", field), [&] { validate(profile); });
}

/// Existing features must be adjacent: absent ones are at the ends of the list.
void check_features(const std::vector<double>& features, std::size_t of_first, const std::string& field) {
    if (features.size() != of_first)
        throw InvalidArgument(
            field, "has " + std::to_string(features.size()) + " entries, but the first slice has " +
                       std::to_string(of_first) +
                       "; all slices need the same number, with -1 for a feature that does not exist in a slice");
    std::size_t existing = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
        if (features[i] < 0) continue;
        const std::string entry = field + "[" + std::to_string(i) + "]";
        if (existing++ == 0) continue;
        require(features[i - 1] >= 0, entry, features[i],
                "be negative, because features after a missing one must also be missing");
        require(features[i] - features[i - 1] >= 1e-3, entry, features[i],
                "exceed the previous one, " + number_text(features[i - 1]));
    }
    if (!features.empty() && existing < 2)
        throw InvalidArgument(field, "has fewer than two existing features; a slice of a rail needs at least two");
}

void check_slices(const WheelRailSetup& setup) {
    const std::vector<RailSlice>& slices = setup.rail_slices;
    if (slices.empty()) return;
    if (slices.size() == 1) throw InvalidArgument("rail_slices", "has one slice; give at least two, or use `rail`");
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const std::string field = "rail_slices[" + std::to_string(i) + "]";
        check_profile(slices[i].profile, ProfileKind::rail, field + ".profile");
        check_features(slices[i].features, slices.front().features.size(), field + ".features");
        if (i > 0)
            require(slices[i].x - slices[i - 1].x >= 1e-3, field + ".x", slices[i].x,
                    "exceed the previous one, " + number_text(slices[i - 1].x));
    }
    if (!setup.track.rail_origin)
        throw InvalidArgument(
            "track.rail_origin",
            "is missing; a rail with slices may have no gauge point, so its position must be given here");
    if (setup.track.roller_radius)
        throw InvalidArgument("track.roller_radius", "is given, but a roller has no slices: remove one of them");
}

void check_slices(const std::vector<WheelSlice>& slices) {
    constexpr double turn = 2 * std::numbers::pi, closest = 1e-5;
    if (slices.size() == 1) throw InvalidArgument("wheel_slices", "has one slice; give at least two, or use `wheel`");
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const double angle = slices[i].angle;
        const std::string field = "wheel_slices[" + std::to_string(i) + "]";
        check_profile(slices[i].profile, ProfileKind::wheel, field + ".profile");
        if (i == 0) continue;
        require(angle - slices[i - 1].angle >= closest, field + ".angle", angle,
                "be larger than the previous one, " + number_text(slices[i - 1].angle) + " rad");
        require(angle - slices[0].angle <= turn - closest, field + ".angle", angle,
                "be less than the first one, " + number_text(slices[0].angle) +
                    " rad, plus a full turn; the first slice repeats after a turn");
    }
}

void check(const PatchRules& rules) {
    require(rules.distance_separate > rules.distance_combine, "patches.distance_separate", rules.distance_separate,
            "be larger than patches.distance_combine, " + number_text(rules.distance_combine));
    require(rules.distance_turn > rules.distance_separate, "patches.distance_turn", rules.distance_turn,
            "be larger than patches.distance_separate, " + number_text(rules.distance_separate));
}

/// A single coefficient at all angles is a number without an index in every client except C++.
void check_single(const std::optional<WheelRailFriction>& friction) {
    if (friction && friction->mu.size() == 1 && friction->mu[0].angle == 0)
        below("friction", [&] { check_bounds(friction->mu[0]); });
}

void check(const WheelRailFriction& friction) {
    if (friction.mu.empty()) throw InvalidArgument("friction.mu", "is empty; it needs at least one coefficient");
    for (std::size_t i = 1; i < friction.mu.size(); ++i)
        require(friction.mu[i].angle > friction.mu[i - 1].angle, "friction.mu[" + std::to_string(i) + "].angle",
                friction.mu[i].angle, "be larger than the previous one, " + number_text(friction.mu[i - 1].angle));
    if (friction.layer) validate(*friction.layer);
}

void check_models(const WheelRailSetup& setup) {
    ContactSetup models;
    models.model = setup.model;
    models.normal_model = setup.normal_model;
    models.simplified = setup.simplified;
    validate_models(models);
    if (setup.normal_model == NormalModel::of_model) return;
    if (setup.normal_model == NormalModel::elliptic || setup.normal_model == NormalModel::parabolic)
        throw InvalidArgument("normal_model",
                              "prescribes pressures over an ellipse, which contact patches on rails do not have; use "
                              "kp, kpec or analyn, or remove it");
    if (setup.conformal != Conformal::off)
        throw InvalidArgument("conformal",
                              "is not off, but normal_model computes pressures in a plane; remove one of them");
    if (setup.sheet_flexibility > 0)
        throw InvalidArgument(
            "sheet_flexibility",
            "is " + number_text(setup.sheet_flexibility) +
                " mm^3/N, but normal_model does not support a sheet between bodies; remove one of them");
}

/// The least coefficient is at one of the angles of either list, because both are linear between angles.
void check_by_angle(const WheelRailFriction& friction) {
    const auto& laws = friction.temperature_by_angle;
    if (laws.empty()) return;
    if (friction.temperature)
        throw InvalidArgument("friction.temperature_by_angle",
                              "cannot be combined with friction.temperature; remove one of them");
    for (std::size_t i = 1; i < laws.size(); ++i)
        require(laws[i].angle > laws[i - 1].angle, "friction.temperature_by_angle[" + std::to_string(i) + "].angle",
                laws[i].angle, "be larger than the previous one, " + number_text(laws[i - 1].angle));
    const auto check_at = [&](double angle) {
        const double mu = coefficient_at(friction.mu, angle);
        validate(law_at(laws, angle), {&mu, 1});
    };
    for (const TemperatureFrictionAtAngle& law : laws) check_at(law.angle);
    for (const FrictionAtAngle& entry : friction.mu) check_at(entry.angle);
}

void check_temperature(const WheelRailSetup& setup) {
    if (setup.friction && setup.friction->memory && setup.friction->temperature_by_angle.empty())
        throw InvalidArgument("friction.memory",
                              "requires friction.temperature_by_angle. Give friction.temperature.memory or "
                              "friction.kinetic.memory, or remove it");
    if (setup.friction && setup.friction->follows_temperature()) {
        if (!setup.temperature)
            throw InvalidArgument(
                "friction.temperature",
                "requires the thermal properties of the bodies: give temperature, or remove friction.temperature");
        std::vector<double> mu;
        for (const FrictionAtAngle& entry : setup.friction->mu) mu.push_back(entry.mu);
        if (setup.friction->temperature) validate(*setup.friction->temperature, mu);
        check_by_angle(*setup.friction);
        if (setup.friction->kinetic)
            throw InvalidArgument("friction.temperature",
                                  "cannot be combined with friction.kinetic, because friction depends either on the "
                                  "temperature or on the slip velocity: remove one of them");
        if (setup.model != Model::full)
            throw InvalidArgument("friction.temperature", "is not supported by simplified models: use model full");
    }
    if (!setup.temperature) return;
    validate(*setup.temperature, "temperature");
    if (!setup.friction)
        throw InvalidArgument("temperature",
                              "requires rolling contact with friction: give friction, or remove temperature");
    if (setup.model == Model::hertz)
        throw InvalidArgument("model",
                              "is hertz, but temperature requires the slip of each element, which this model does not "
                              "compute: use full or fastsim");
}

void check_wear(const WheelRailSetup& setup) {
    if (!setup.wear) return;
    validate(*setup.wear, "wear");
    check_wear_model(setup.model);
    if (!setup.friction)
        throw InvalidArgument("wear", "requires rolling contact with friction: give friction, or remove wear");
    check_wear_layer(setup.friction->layer);
}

void check_fatigue(const WheelRailSetup& setup) {
    if (!setup.fatigue) return;
    validate(*setup.fatigue, "fatigue");
    check_fatigue_model(setup.model);
    if (!setup.friction)
        throw InvalidArgument(
            "fatigue",
            "requires rolling contact with friction: give friction, whose coefficient may be small, or remove fatigue");
}

}  // namespace

void validate(const WheelRailSetup& setup) {
    check_profile(setup.wheel, ProfileKind::wheel, "wheel");
    check_profile(setup.rail, ProfileKind::rail, "rail");
    check(setup.track);
    check_single(setup.friction);
    check_bounds(setup);
    check_slices(setup);
    check_slices(setup.wheel_slices);
    check(setup.wheelset);
    // The grid is only known at each contact; bodies that need one are checked there.
    validate(setup.bodies, Grid::of_elements(2, 2, 1, 1));
    for (const auto& [body, name] : {std::pair(&setup.bodies.upper, "bodies.upper.viscoelastic"),
                                     std::pair(&setup.bodies.lower, "bodies.lower.viscoelastic")})
        if (body->viscoelastic)
            throw InvalidArgument(name, "is given, but wheel-rail contact supports elastic bodies only: remove it");
    if (setup.bodies.any_uniform())
        throw InvalidArgument("bodies",
                              "have a section, which wheel-rail contact does not support; give materials, and set "
                              "conformal to fem if the cross-sections matter");
    if (setup.friction) check(*setup.friction);
    if (setup.friction && setup.friction->along_profile && setup.model != Model::full)
        throw InvalidArgument("friction.along_profile",
                              "is set, but simplified models use one coefficient for the whole patch; use model full");
    check_models(setup);
    if (setup.conformal != Conformal::off && setup.model != Model::full)
        throw InvalidArgument("conformal",
                              "is not off, but simplified models support ellipses in a plane only; use model full");
    if (setup.conformal == Conformal::fem && !setup.rail_slices.empty())
        throw InvalidArgument("conformal",
                              "is fem, but the rail has slices; coefficients by cross-sections require a rail that is "
                              "uniform along x: use rotated");
    if (setup.conformal == Conformal::fem && !setup.wheel_slices.empty())
        throw InvalidArgument(
            "conformal",
            "is fem, but the wheel has slices; coefficients by cross-sections require a round wheel: use rotated");
    if (setup.rigid_slip != RigidSlipKind::plane && setup.model != Model::full)
        throw InvalidArgument("rigid_slip", "is not plane, but simplified models use creepages only; use model full");
    if (setup.friction && setup.friction->layer && setup.model != Model::full)
        throw InvalidArgument("friction.layer",
                              "requires model full; simplified models do not support a layer between bodies");
    if (setup.sheet_flexibility > 0 && setup.model != Model::full)
        throw InvalidArgument(
            "sheet_flexibility",
            "is " + number_text(setup.sheet_flexibility) +
                " mm^3/N, but simplified models do not support a sheet between bodies; use model full");
    check_temperature(setup);
    check_wear(setup);
    check_fatigue(setup);
    if (setup.settings.tangential_solver == TangentialSolver::tangcg)
        throw InvalidArgument(
            "settings.tangential.solver",
            "is tangcg, which requires symmetric operators and does not support steady rolling; use newton");
    constexpr double rounding = 1e-9;
    require(setup.conformal != Conformal::fem || setup.dx >= shortest_uniform_element * setup.dy * (1 - rounding), "dx",
            setup.dx, "be at least half of dy if conformal is fem");
    require(setup.conformal != Conformal::fem || setup.patches.max_elements == 0, "patches.max_elements",
            setup.patches.max_elements, "be removed if conformal is fem, whose sections are divided by dy");
    check(setup.patches);
}

double step_of_rolling(const WheelRailSetup& setup, double dx) {
    return setup.dq > 0 ? setup.dq * (dx / setup.dx) : dx;
}

WheelRailSetup with_tolerances(const WheelRailSetup& setup) {
    WheelRailSetup chosen = setup;
    if (!setup.accuracy) return chosen;
    chosen.force.tolerance = *setup.accuracy;
    chosen.settings.normal.tolerance = normal_per_accuracy * *setup.accuracy;
    chosen.settings.tangential.tolerance = tangential_per_accuracy * *setup.accuracy;
    chosen.settings.outer.tolerance = tangential_per_accuracy * *setup.accuracy;
    return chosen;
}

bool has_distances(const WheelRailSetup& setup) {
    return setup.model == Model::full || setup.normal_model != NormalModel::of_model;
}

WheelRailSetup setup_of(const WheelsetSetup& wheelset, Side side) {
    WheelRailSetup setup = side == Side::left && wheelset.left ? *wheelset.left : wheelset.setup;
    setup.side = side;
    return setup;
}

}  // namespace contactd

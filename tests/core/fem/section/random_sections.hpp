// Creates random cross-sections, and contacts on them: ready-made shapes and outlines of lines, arcs, splines and
// holes, with loads and motions of every kind. Dense sums check all contact conditions.
#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/curved_faults.hpp"
#include "contact/random_contact.hpp"
#include "contactd/closed_form_record.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/strip_frames.hpp"

namespace contactd::test {

inline constexpr double table_accuracy = 1e-2;

inline SectionPoint between(const SectionPoint& a, const SectionPoint& b, double share) {
    return {a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/// Round, anticlockwise: two arcs.
inline Outline round_hole(const SectionPoint& centre, double radius) {
    const SectionPoint right{centre.y + radius, centre.z}, left{centre.y - radius, centre.z};
    return {right, {{ArcTo{left, -radius}}, {ArcTo{right, -radius}}}};
}

/// Creates a block whose top is a line, an arc or a spline, with inclined sides and perhaps a hole, clamped below.
/// Strips with the total `length` lie on its top or in the hole. Some of them are invalid.
inline OutlineSection random_outline(Dice& dice, double length) {
    const double half = length * dice.uniform(0.55, 3), height = length * dice.log_uniform(0.4, 8);
    const SectionPoint left{-half, 0}, right{half, dice.chance(0.5) ? 0 : 0.2 * height * dice.uniform(-1, 1)};
    OutlinePart top{LineTo{right}};
    const int kind = dice.integer(0, 2);
    if (kind == 1) top.curve = ArcTo{right, half * dice.log_uniform(1.05, 20) * (dice.chance(0.5) ? 1 : -1)};
    if (kind == 2) {
        SplineTo spline;
        const int count = dice.integer(1, 5);
        for (int i = 1; i <= count; ++i) {
            spline.through.push_back(between(left, right, static_cast<double>(i) / (count + 1)));
            spline.through.back().z += 0.2 * half * dice.uniform(-1, 1);
        }
        spline.through.push_back(right);
        top.curve = spline;
    }
    const auto lean = [&] { return half * dice.uniform(-0.3, 0.5); };
    OutlineSection section;
    section.outside = {left,
                       {top,
                        {LineTo{{half + lean(), -height}}, dice.chance(0.2)},
                        {LineTo{{-half - lean(), -height}}, true},
                        {LineTo{left}}}};
    section.from = dice.uniform(0, std::max(2 * half - length, 0.0));
    if (dice.chance(0.3)) {
        const double radius = std::min(half, height) * dice.uniform(0.1, 0.4);
        section.holes = {round_hole({half * dice.uniform(-0.4, 0.4), -height * dice.uniform(0.45, 0.6)}, radius)};
        if (std::numbers::pi * radius > length && dice.chance(0.7)) {
            section.carrier = 1;
            section.part = static_cast<std::size_t>(dice.integer(0, 1));
            section.from = dice.uniform(0, std::numbers::pi * radius - length);
        }
    }
    return section;
}

inline Section random_section(Dice& dice, double length) {
    Section section{random_outline(dice, length)};
    const auto times = [&](double low, double high) { return length * dice.log_uniform(low, high); };
    switch (dice.integer(0, 15)) {
        case 0:
            section.shape = EdgeBlock{times(2, 50), times(0.5, 50), dice.chance(0.3) ? 0 : times(0.01, 0.9)};
            break;
        case 1: {
            const double radius = times(0.4, 5);
            section.shape = Groove{radius, radius * dice.uniform(0.3, 1), radius * dice.uniform(2.5, 12), times(3, 20)};
            break;
        }
        case 2:
            section.shape = RoundEnd{times(0.35, 5), times(1, 20)};
            break;
        case 3: {
            const double radius = times(0.4, 4);
            section.shape = Disc{radius, radius * dice.log_uniform(0.005, 0.6)};
            break;
        }
        case 4: {
            const double radius = times(0.4, 4);
            section.shape = PlateHole{radius, radius * dice.log_uniform(1.3, 50)};
            break;
        }
        case 5:
            section.shape = Slab{times(0.05, 100), times(1.2, 100)};
            break;
        case 6:
            section.shape = RailSection{dice.uniform(-0.05, 0.05),
                                        dice.chance(0.3) ? RailSupport::foot : RailSupport::cut, dice.uniform(-25, 35)};
            section.size = length / dice.log_uniform(2, 30);
            break;
        case 7:
            section.shape = WheelRimSection{dice.uniform(30, 80), dice.uniform(-50, 20)};
            section.size = length / dice.log_uniform(2, 30);
            break;
        case 8:
            section.shape = ProfileSection{{ProfileKind::rail, ArcProfile{dice.log_uniform(30, 500), 0, -25, 25}},
                                           dice.uniform(15, 100),
                                           dice.uniform(-20, 0)};
            section.size = length / dice.log_uniform(2, 20);
            break;
        default:
            break;
    }
    if (dice.chance(0.5)) section.turn = dice.uniform(-3, 3);
    return section;
}

/// Holds a contact on a random section with its coefficients, or in `refused` the reason for a refusal.
struct SectionContact {
    ContactProblem problem;
    BodyTable upper, lower;
    StripTable pair;  ///< tables of both bodies, for the check
    std::string refused{};
};

inline IcSpec spec_of(const Body& body, const Grid& grid, int nx) {
    return {std::get<Ics>(body.ics), body.material, grid.dx, grid.dy, nx, grid.ny};
}

/// Places it on a rigid body, or on the half-space of the same or another material, which is then the upper one.
inline void add_bodies(Dice& dice, const Section& section, SectionContact& contact) {
    constexpr int more = 3;  // offsets, for rolling
    ContactProblem& problem = contact.problem;
    const Grid& grid = problem.grid;
    Ics ics;
    ics.source = IcSource::fem;
    ics.body = BodyShape::longitudinally_uniform;
    ics.accuracy = table_accuracy;
    ics.section = section;
    problem.bodies.lower = {{dice.log_uniform(1, 1e5), dice.uniform(0, 0.45)}, ics};
    problem.bodies.upper = {Material::rigid()};
    if (dice.chance(0.4)) problem.bodies.upper = {problem.bodies.lower.material};
    if (dice.chance(0.2)) problem.bodies.upper = {random_material(dice)};
    Observer observer;
    const IcSpec lower = spec_of(problem.bodies.lower, grid, grid.nx + more),
                 upper = spec_of(problem.bodies.upper, grid, grid.nx + more);
    contact.lower = body_table(fem::build_ic_table(lower, observer), lower);
    const auto& table = std::get<StripTable>(contact.lower);
    contact.upper = IcTable(upper.nx, upper.ny);
    contact.pair = table;
    if (problem.bodies.upper.material.is_rigid()) return;
    contact.upper = half_space_table(upper);
    contact.pair = pair_of(strip_table_of(std::get<IcTable>(contact.upper)), table);
}

/// Moves along x only, by whole elements in rolling, with forces along x only.
inline void add_motion(Dice& dice, const ContactSolution& normal, ContactProblem& problem) {
    const double mu = dice.uniform(0.05, 0.6), angle = dice.uniform(0, 6.3);
    problem.friction = FrictionLaw{{mu}};
    const double unit = slip_unit(problem, normal, mu);
    const double length = std::sqrt(std::max(normal.area.contact, problem.grid.element_area()));
    const double size = unit * dice.log_uniform(0.03, 5), turn = dice.chance(0.5) ? unit / length : 0;
    Force force;
    if (dice.chance(0.25)) force.Fx = mu * normal.forces.Fn * dice.uniform(-0.9, 0.9);
    if (dice.chance(0.4)) {
        problem.motion = Shift{{size * std::cos(angle), size * std::sin(angle)}, turn * dice.uniform(-1, 1), force};
        return;
    }
    Rolling rolling{.xi = size / length * std::cos(angle),
                    .eta = size / length * std::sin(angle),
                    .phi = turn / length * dice.uniform(-1, 1),
                    .chi = dice.chance(0.5) ? 0 : std::numbers::pi,
                    .spin_offset = dice.uniform(0, 1),
                    .force = force};
    if (dice.chance(0.3)) rolling.kind = RollingKind::transient;
    problem.motion = rolling;
}

inline ContactSolution solve(const SectionContact& contact) {
    Observer observer;
    return solve_contact(contact.problem, make_influence(contact.problem, contact.upper, contact.lower), observer);
}

/// There is a problem to solve if `refused` is empty.
inline SectionContact random_section_contact(std::uint64_t seed) {
    Dice dice(seed + 55'000'000);
    SectionContact contact;
    ContactProblem& problem = contact.problem;
    const double dy = dice.log_uniform(0.05, 2), dx = dy * dice.log_uniform(0.5, 3);
    const int nx = dice.integer(2, 12), ny = dice.integer(2, 11);
    problem.grid = Grid::of_elements(nx, ny, dx, dy);
    const Section section = random_section(dice, ny * dy);
    try {
        problem.columns.emplace();
        problem.columns->frames = strip_frames(section, ny, dy, "ics.section");
        add_bodies(dice, section, contact);
    } catch (const InvalidArgument& error) {
        contact.refused = error.what();
        return contact;
    }
    ContactColumns& strips = *problem.columns;
    const auto& frames = strips.frames;
    const StripFrame& middle = frames[static_cast<std::size_t>(dice.integer(0, ny - 1))];
    strips.origin = {middle.y, middle.z};
    const auto [least, most] = std::ranges::minmax(frames, {}, [](const StripFrame& frame) { return frame.angle; });
    strips.direction = std::clamp(middle.angle, most.angle - 1.5, least.angle + 1.5);
    if (most.angle - least.angle > 3) {
        contact.refused = "strips that face all sides";
        return contact;
    }
    problem.gap = random_distance(dice, problem.grid);
    const auto& h = std::get<Values>(*problem.gap);
    const auto [nearest, farthest] = std::ranges::minmax(h);
    problem.approach = nearest + dice.log_uniform(1e-3, 1) * std::max(farthest - nearest, 1e-3);
    problem.settings.normal.tolerance = 1e-11;
    problem.settings.tangential.tolerance = 1e-9;
    problem.settings.outer = {1e-8, 300};
    const ContactSolution normal = solve(contact);
    if (dice.chance(0.5)) {
        problem.Fn = normal.forces.Fn;
        problem.approach.reset();
    }
    if (dice.chance(0.1) || normal.pmax == 0) return contact;
    add_motion(dice, normal, problem);
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (dice.chance(0.4) && !(rolling && rolling->steady())) problem.previous = state_of(solve(contact));
    return contact;
}

/// Returns the errors of its solution; empty if there are none.
inline std::string section_faults(const SectionContact& contact, const ContactSolution& solution) {
    if (!solution.converged()) return "not converged";
    // Products change no coefficient by more than a thousandth of the accuracy of tables.
    const ContactProblem& problem = contact.problem;
    double self = 0;
    for (const Body* body : {&problem.bodies.upper, &problem.bodies.lower})
        if (!body->material.is_rigid())
            self += half_space_coefficient(Axis::z, Axis::z, 0, 0, problem.grid.dx, problem.grid.dy, body->material);
    const double left_out = 1e-3 * table_accuracy * self;
    const std::string normal = curved_normal_faults(problem, contact.pair, solution, 1e-6, left_out);
    if (!normal.empty() || !problem.friction) return normal;
    return curved_friction_faults(problem, contact.pair, solution, 1e-4, left_out);
}

}  // namespace contactd::test

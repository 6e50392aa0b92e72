#include "contactd/contact_columns.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "types/area/contact_columns_check.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

std::string frame(std::size_t at) {
    return "columns.frames[" + std::to_string(at) + "]";
}

// A chord is never longer than its arc, and only slightly shorter if columns are suitable for a contact.
void check_distance(const ContactColumns& columns, std::size_t at, double dy) {
    constexpr double longest = 1 + 1e-6, shortest = 0.6;
    const StripFrame &here = columns.frames[at], &before = columns.frames[at - 1];
    const double distance = std::hypot(here.y - before.y, here.z - before.z);
    if (distance >= shortest * dy && distance <= longest * dy) return;
    throw InvalidArgument(frame(at), "lies " + number_text(distance) +
                                         " mm from the previous frame; adjacent columns of arc length grid.dy = " +
                                         number_text(dy) + " mm must be that far apart or slightly less");
}

void check_facing(const ContactColumns& columns, std::size_t at) {
    const double angle = columns.frames[at].angle;
    if (std::cos(angle - columns.direction) >= least_facing) return;
    throw InvalidArgument(frame(at) + ".angle",
                          "is " + number_text(angle) + " and columns.direction " + number_text(columns.direction) +
                              "; a column must face the approaching body, at less than a right angle to it");
}

void check_finite(double value, const std::string& field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is not finite");
}

void check_numbers(const ContactColumns& columns) {
    check_finite(columns.direction, "columns.direction");
    check_finite(columns.origin.y, "columns.origin.y");
    check_finite(columns.origin.z, "columns.origin.z");
    for (std::size_t at = 0; at < columns.frames.size(); ++at) {
        check_finite(columns.frames[at].y, frame(at) + ".y");
        check_finite(columns.frames[at].z, frame(at) + ".z");
        check_finite(columns.frames[at].angle, frame(at) + ".angle");
    }
}

void check_motion(const Rolling& rolling) {
    constexpr double rounding = 1e-9;
    if (std::abs(std::sin(rolling.chi)) > rounding)
        throw InvalidArgument("friction.rolling.chi", "is " + number_text(rolling.chi) +
                                                          "; on curved columns bodies roll along x: use 0 or pi");
    if (rolling.force.Fy)
        throw InvalidArgument(
            "friction.rolling.force",
            "contains Fy; on curved columns only Fx can be prescribed: remove Fy and prescribe the creepage eta");
}

void check_motion(const Shift& shift) {
    if (shift.force.Fy)
        throw InvalidArgument("friction.force",
                              "contains Fy; on curved columns only Fx can be prescribed: remove Fy and prescribe the "
                              "rigid shift along y");
}

}  // namespace

void check_columns(const ContactProblem& problem) {
    if (!problem.columns) return;
    const ContactColumns& columns = *problem.columns;
    if (columns.frames.size() != static_cast<std::size_t>(problem.grid.ny))
        throw InvalidArgument("columns.frames", "has " + std::to_string(columns.frames.size()) +
                                                    " frames; the grid has " + std::to_string(problem.grid.ny) +
                                                    " rows, and each row is one column of the surface");
    check_numbers(columns);
    for (std::size_t at = 0; at < columns.frames.size(); ++at) {
        if (at > 0) check_distance(columns, at, problem.grid.dy);
        check_facing(columns, at);
    }
    if (problem.model != Model::full)
        throw InvalidArgument("model", "is a closed form, which does not exist on curved columns: use model full");
    if (problem.gap && !std::holds_alternative<std::vector<double>>(*problem.gap))
        throw InvalidArgument(
            "gap", "is defined over a plane; on curved columns, give an array of distances along their normals");
    if (problem.derivatives)
        throw InvalidArgument("derivatives", "are not available on curved columns; use finite differences of solves");
    if (problem.friction) std::visit([](const auto& motion) { check_motion(motion); }, problem.motion);
}

}  // namespace contactd

// contactd.h: contact on curved columns, where they lie and what acts on them together.
#include <string>

#include "bodies_said.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::InvalidArgument;
using contactd::StripFrame;

namespace {

double finite_of_frame(double value, std::size_t at, const char* what) {
    return finite(value, ("columns.frames[" + std::to_string(at) + "]." + what).c_str());
}

}  // namespace

std::int32_t contactd_set_columns(contactd_contact* contact, const double* y, const double* z, const double* angle,
                                  std::int32_t count, double direction, double origin_y, double origin_z) {
    return set_up(contact, "columns", [&](Said& said) {
        const auto of_y = array(y, count, "columns.frames.y"), of_z = array(z, count, "columns.frames.z");
        const auto angles = array(angle, count, "columns.frames.angle");
        contactd::ContactColumns columns;
        for (std::size_t i = 0; i < of_y.size(); ++i)
            columns.frames.push_back({finite_of_frame(of_y[i], i, "y"), finite_of_frame(of_z[i], i, "z"),
                                      finite_of_frame(angles[i], i, "angle")});
        columns.direction = finite(direction, "columns.direction");
        columns.origin = {finite(origin_y, "columns.origin.y"), finite(origin_z, "columns.origin.z")};
        said.problem.columns = std::move(columns);
    });
}

std::int32_t contactd_get_frames(contactd_contact* contact, std::int32_t body, double* y, double* z, double* angle,
                                 std::int32_t length) {
    return with(contact, [&](Contact& asked) {
        given(y, "y"), given(z, "z"), given(angle, "angle");
        word(body, CONTACTD_LOWER, "body");
        contactd::Bodies& bodies = asked.said.problem.bodies;
        const contactd::Section& section = *prism_of(body == CONTACTD_UPPER ? bodies.upper : bodies.lower).section;
        const contactd::Grid& grid = asked.said.problem.grid;
        validate(grid, "grid");
        if (length != grid.ny)
            throw InvalidArgument("length", "is " + std::to_string(length) + "; the grid has " +
                                                std::to_string(grid.ny) + " rows, which are the columns");
        const std::vector<StripFrame> frames = asked.frames(section);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            y[i] = frames[i].y;
            z[i] = frames[i].z;
            angle[i] = frames[i].angle;
        }
    });
}

std::int32_t contactd_get_resultant(contactd_contact* contact, double* forces) {
    return with(contact, [&](Contact& asked) {
        given(forces, "forces");
        const auto& resultant = asked.result().reply.solution.resultant;
        if (!resultant) throw nothing_of("resultant: the contact lies in a plane");
        const double all[] = {resultant->Fx, resultant->Fy, resultant->Fz, resultant->Mx, resultant->My, resultant->Mz};
        std::copy(std::begin(all), std::end(all), forces);
    });
}

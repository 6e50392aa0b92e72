// Implements contactd.h: tables of coefficients, and frames of columns.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api_boundary.hpp"

using namespace contactd::c;
using contactd::InvalidArgument;
using contactd::StripFrame;

namespace {

/// Returns the coefficients at the path.
std::optional<contactd::Coefficients>& coefficients_at(ContactInputs& inputs, const std::string& path) {
    if (path == "ics") return inputs.ics;
    if (path == "bodies.upper.ics") return inputs.upper.ics;
    if (path != "bodies.lower.ics")
        throw InvalidArgument(path, "cannot be a table; only ics, bodies.upper.ics and bodies.lower.ics can");
    if (!inputs.lower) inputs.lower.emplace();
    return inputs.lower->ics;
}

}  // namespace

std::int32_t contactd_set_table(contactd_contact* contact, const char* path, std::int32_t nx, std::int32_t ny,
                                double dx, double dy, const double* values, std::int32_t count) {
    return with(contact, [&](Contact& object) {
        const std::string name = given(path, "path");
        object.require_set_up(name.c_str());
        const std::vector<double> copied = array(values, count, "values");
        if (nx < 1 || ny < 1 || copied.size() != 9 * static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny))
            throw InvalidArgument("count", "is " + std::to_string(count) + "; it must be 9*nx*ny");
        contactd::GivenIcs table{{}, finite(dx, (name + ".dx").c_str()), finite(dy, (name + ".dy").c_str())};
        table.table.nx = nx;
        table.table.ny = ny;
        table.table.values.assign(copied.begin(), copied.end());
        coefficients_at(object.inputs, name) = std::move(table);
    });
}

std::int32_t contactd_get_frames(contactd_contact* contact, const char* body, double* y, double* z, double* angle,
                                 std::int32_t length) {
    return with(contact, [&](Contact& object) {
        const std::string name = given(body, "body");
        given(y, "y"), given(z, "z"), given(angle, "angle");
        if (name != "upper" && name != "lower")
            throw InvalidArgument("body", "is \"" + name + "\"; it must be one of upper, lower");
        const contactd::Section* section = object.inputs.section_of(name == "upper");
        if (section == nullptr)
            throw InvalidArgument("bodies." + name + ".ics.section",
                                  "is missing; only a body with a section has columns");
        const contactd::Grid grid = object.inputs.grid();
        validate(grid, "grid");
        if (length != grid.ny)
            throw InvalidArgument("length", "is " + std::to_string(length) + "; the grid has " +
                                                std::to_string(grid.ny) + " rows, one for each column");
        const std::vector<StripFrame> frames = object.frames(*section);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            y[i] = frames[i].y;
            z[i] = frames[i].z;
            angle[i] = frames[i].angle;
        }
    });
}

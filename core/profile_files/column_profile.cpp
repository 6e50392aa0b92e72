// Reads two columns, as written by tables, spreadsheets and other programs.
#include <algorithm>
#include <string>
#include <vector>

#include "profile_lines.hpp"

namespace contactd::geometry {
namespace {

bool is_heading(std::string_view line) {
    return std::ranges::none_of(fields_of(line, ",;"), [](std::string_view field) {
        return number_in(field) || field == "nan" || field == "NaN" || field == "inf" || field.empty();
    });
}

}  // namespace

FilePoints read_columns(std::string_view text, const std::string& name) {
    ProfileLines lines(text, name, "#%!");
    FilePoints found;
    std::vector<ProfilePoint>& points = found.points.points;
    if (const auto unit = unit_in_heading(text, name)) {
        found.points.unit = *unit;
        found.heading_says_unit = true;
    }
    NumberStyle style;
    while (lines.next()) {
        std::string line(lines.line());
        if (std::ranges::count(line, '"') % 2 == 0)
            std::erase(line, '"');
        else
            line.erase(line.find('"'));  // a comment
        if (trimmed(line).empty()) continue;
        const auto values = style.numbers(line);
        if (!values && points.empty() && is_heading(line)) {
            ++found.lines_left_out;
            continue;
        }
        if (!values) lines.numbers(",;");  // which reports an invalid number
        if (!values || values->size() != 2)
            lines.fail("has " + std::to_string(values ? values->size() : 0) +
                       " numbers, but a point has two, y and z. If commas are decimal signs, separate numbers by "
                       "blanks, tabs or semicolons");
        add_point(points, {values->at(0), values->at(1)}, lines);
    }
    return found;
}

}  // namespace contactd::geometry

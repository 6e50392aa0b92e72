// Reads MiniProf's files of all years: a head of keys, and the points.
#include <algorithm>
#include <string>
#include <vector>

#include "profile_lines.hpp"

namespace contactd::geometry {
namespace {

bool begins_a_word(std::string_view text) {
    const char first = text.empty() ? ' ' : text.front();
    return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
}

/// Holds the properties of the points in the head of a MiniProf file.
struct MiniprofHead {
    std::size_t columns = 0, x = 0, y = 1;  // 0 columns: any number
    double x_offset = 0, y_offset = 0;

    /// Returns whether the key of the line affects the profile.
    bool read(const ProfileLines& lines) {
        const auto at = lines.line().find('=');
        const std::string_view key = trimmed(lines.line().substr(0, at)), value = trimmed(lines.line().substr(at + 1));
        if (value.empty()) return false;
        if (key == "ColumnDef")
            read_columns(lines, value);
        else if (key == "XOffset" || key == "Xoffset")
            x_offset = lines.number(value);
        else if (key == "YOffset" || key == "Yoffset")
            y_offset = lines.number(value);
        else
            return false;
        return true;
    }

    /// The text after the numbers is a remark.
    ProfilePoint point(const ProfileLines& lines, NumberStyle& style) const {
        std::string_view line = lines.line(), remark;
        for (const std::string_view field : fields_of(line, ",;"))
            if (remark.empty() && field.data() != line.data() && begins_a_word(field)) remark = field;
        if (!remark.empty()) line = line.substr(0, static_cast<std::size_t>(remark.data() - line.data()));
        const auto found = style.numbers(trimmed(line));
        if (!found) lines.numbers(",;");  // which reports an invalid number
        const std::vector<double>& values = *found;
        if (!remark.empty() && values.size() < std::max<std::size_t>(columns, 2)) lines.number(remark);
        if (values.size() < 2 || (columns > 0 && values.size() != columns))
            lines.fail("has " + std::to_string(values.size()) + " numbers; it must have " +
                       (columns > 0 ? std::to_string(columns) + ", as ColumnDef states" : "at least two, X and Y"));
        return {values[x] + x_offset, values[y] + y_offset};
    }

   private:
    void read_columns(const ProfileLines& lines, std::string_view names) {
        const auto fields = fields_of(names, ",");
        const auto column_of = [&](std::string_view column) {
            const auto found = std::ranges::find(fields, column);
            if (found == fields.end())
                lines.fail("has the columns " + quoted(names) + "; X and Y must be among them, as X,Y");
            return static_cast<std::size_t>(found - fields.begin());
        };
        x = column_of("X"), y = column_of("Y");
        columns = fields.size();
    }
};

bool is_number_line(std::string_view line) {
    const auto fields = fields_of(line, ",;");
    return !fields.empty() && number_in(fields.front()).has_value();
}

}  // namespace

/// The file has a head of lines key=value, an empty line, and then a line for each point. Old files contain only keys
/// in the head, and a line of numbers among them. Some files lack the empty line.
FilePoints read_miniprof(std::string_view text, const std::string& name) {
    ProfileLines lines(text, name, "!\"%#");
    FilePoints found;
    std::vector<ProfilePoint>& points = found.points.points;
    MiniprofHead head;
    NumberStyle style;
    bool in_head = true, begun = false, has_keys_alone = false;
    while (lines.next()) {
        if (begun && lines.follows_empty()) in_head = false;
        begun = true;
        const auto line = lines.line();
        if (line.find('=') != line.npos) {
            if (!points.empty())
                lines.fail("is " + quoted(line) +
                           " after points; a file has one profile, and its header precedes the points");
            if (!head.read(lines)) ++found.lines_left_out;
        } else if (in_head && (has_keys_alone || !is_number_line(line))) {
            has_keys_alone = true;
            ++found.lines_left_out;
        } else {
            in_head = false;
            add_point(points, head.point(lines, style), lines);
        }
    }
    return found;
}

}  // namespace contactd::geometry

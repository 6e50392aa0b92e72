#include "contactd/read_profile.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "points_upwards.hpp"
#include "profile_lines.hpp"

namespace contactd {
namespace {

using geometry::ProfileLines;
using geometry::quoted;

/// Ending of a file's name, in small letters.
std::string ending_of(const std::string& name) {
    const auto dot = name.rfind('.');
    std::string ending = dot == name.npos ? "" : name.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

void check_kind(const std::string& name, ProfileKind of_file, std::optional<ProfileKind> kind) {
    if (kind && *kind != of_file)
        throw InvalidArgument(name, "is the file of a " + std::string(name_of(of_file)) + ", and a " +
                                        std::string(name_of(*kind)) + " is asked for; take its file, or its kind");
}

}  // namespace

namespace geometry {

namespace {

/// How the numbers of a file of columns are written. Decimal commas are known by what stands between the numbers.
struct ColumnStyle {
    bool has_decimal_commas = false;

    /// The numbers of a line; nothing where one of its fields is none.
    std::optional<std::vector<double>> numbers(std::string_view line) {
        std::vector<double> values;
        bool any_comma = false;
        const auto fields = fields_of(line, ";");
        for (const std::string_view field : fields) {
            std::string digits(field);
            if (const auto comma = digits.find(','); comma != digits.npos) {
                digits[comma] = '.';
                any_comma = any_comma || (comma > 0 && comma + 1 < digits.size());
            }
            if (const auto value = number_in(digits)) values.push_back(*value);
        }
        if (values.size() == fields.size() && (fields.size() > 1 || has_decimal_commas || !any_comma)) {
            has_decimal_commas = has_decimal_commas || any_comma;
            return values;
        }
        values.clear();
        for (const std::string_view field : fields_of(line, ",;")) {
            const auto value = number_in(field);
            if (!value) return {};
            values.push_back(*value);
        }
        return values;
    }
};

bool is_heading(std::string_view line) {
    return std::ranges::none_of(fields_of(line, ",;"), [](std::string_view field) {
        return number_in(field) || field == "nan" || field == "NaN" || field == "inf" || field.empty();
    });
}

/// Turns the points of a file that does not say which way z points.
ProfilePoints turned_by_shape(ProfilePoints given, ProfileKind kind, bool unless_known) {
    given.mirror_z = points_upwards(given.points, kind).value_or(unless_known);
    return given;
}

}  // namespace

ProfilePoints read_columns(std::string_view text, const std::string& name, ProfileKind kind) {
    ProfileLines lines(text, name, "#%!");
    ProfilePoints given;
    ColumnStyle style;
    while (lines.next()) {
        std::string line(lines.line());
        if (std::ranges::count(line, '"') % 2 == 0)
            std::erase(line, '"');
        else
            line.erase(line.find('"'));  // a comment
        if (trimmed(line).empty()) continue;
        const auto values = style.numbers(line);
        if (!values && given.points.empty() && is_heading(line)) continue;
        if (!values) lines.numbers(",;");  // which says what is none
        if (!values || values->size() != 2)
            lines.fail("has " + std::to_string(values ? values->size() : 0) +
                       " numbers; a point has two, y and z; where commas are decimal signs, blanks, tabs or semicolons "
                       "stand between them");
        add_point(given.points, {values->at(0), values->at(1)}, lines);
    }
    return turned_by_shape(std::move(given), kind, false);
}

namespace {

bool begins_a_word(std::string_view text) {
    const char first = text.empty() ? ' ' : text.front();
    return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z');
}

/// What the head of a MiniProf file says of its points.
struct MiniprofHead {
    std::size_t columns = 0, x = 0, y = 1;  // 0 columns: as many as there are
    double x_offset = 0, y_offset = 0;

    void read(const ProfileLines& lines) {
        const auto at = lines.line().find('=');
        const std::string_view key = trimmed(lines.line().substr(0, at)), value = trimmed(lines.line().substr(at + 1));
        if (value.empty()) return;
        if (key == "ColumnDef")
            read_columns(lines, value);
        else if (key == "XOffset" || key == "Xoffset")
            x_offset = lines.number(value);
        else if (key == "YOffset" || key == "Yoffset")
            y_offset = lines.number(value);
    }

    /// What stands behind the numbers is a remark.
    ProfilePoint point(const ProfileLines& lines) const {
        std::vector<double> values;
        for (const std::string_view field : fields_of(lines.line(), ",;")) {
            if (values.size() >= std::max<std::size_t>(columns, 2) && begins_a_word(field)) break;
            values.push_back(lines.number(field));
        }
        if (values.size() < 2 || (columns > 0 && values.size() != columns))
            lines.fail("has " + std::to_string(values.size()) + " numbers; it must have " +
                       (columns > 0 ? std::to_string(columns) + ", as ColumnDef says" : "two at least, X and Y"));
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

/// A head of lines key=value, in old files of keys alone with a line of numbers among them, and an empty line behind
/// it; then a point a line. Some files leave the empty line out.
ProfilePoints read_miniprof(std::string_view text, const std::string& name, ProfileKind kind) {
    ProfileLines lines(text, name, "!\"%#");
    ProfilePoints given;
    MiniprofHead head;
    bool in_head = true, begun = false, has_keys_alone = false;
    while (lines.next()) {
        if (begun && lines.follows_empty()) in_head = false;
        begun = true;
        const auto line = lines.line();
        if (line.find('=') != line.npos) {
            if (!given.points.empty())
                lines.fail("is " + quoted(line) + " behind points; a file has one profile, its head above the points");
            head.read(lines);
        } else if (in_head && (has_keys_alone || !is_number_line(line))) {
            has_keys_alone = true;
        } else {
            in_head = false;
            add_point(given.points, head.point(lines), lines);
        }
    }
    return turned_by_shape(std::move(given), kind, true);
}

}  // namespace geometry

ProfileSpec read_profile(std::string_view text, const std::string& name, std::optional<ProfileKind> kind) {
    if (text.size() > most_profile_bytes)
        throw InvalidArgument(name, "has " + std::to_string(text.size()) + " bytes; a profile has 16 MiB at most");
    const std::string ending = ending_of(name);
    const bool simpack = ending == "prr" || ending == "prw", miniprof = ending == "ban" || ending == "whl";
    if (simpack || miniprof) {
        const auto of_file = ending == "prw" || ending == "whl" ? ProfileKind::wheel : ProfileKind::rail;
        check_kind(name, of_file, kind);
        return {of_file,
                simpack ? geometry::read_simpack(text, name, of_file) : geometry::read_miniprof(text, name, of_file)};
    }
    if (!kind)
        throw InvalidArgument(name,
                              "does not say by its ending whether it is a wheel's or a rail's (.prw, .prr, .whl, "
                              ".ban do); give the kind");
    return {*kind, geometry::read_columns(text, name, *kind)};
}

ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind) {
    const std::string name = file.filename().string();
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) throw InvalidArgument(file.string(), "cannot be read: " + error.message() + "; check its path");
    if (bytes > most_profile_bytes)
        throw InvalidArgument(name, "has " + std::to_string(bytes) + " bytes; a profile has 16 MiB at most");
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw InvalidArgument(file.string(), "cannot be read; check its rights");
    return read_profile(std::string_view(text), name, kind);
}

}  // namespace contactd

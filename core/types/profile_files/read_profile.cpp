#include "contactd/read_profile.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "contactd/error.hpp"
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

ProfilePoints read_columns(std::string_view text, const std::string& name) {
    ProfileLines lines(text, name, "#%!");
    ProfilePoints given;
    while (lines.next()) {
        const auto values = lines.numbers(",;");
        if (values.size() != 2)
            lines.fail("has " + std::to_string(values.size()) +
                       " numbers; a point has two, y and z, with points as decimal signs");
        add_point(given.points, {values[0], values[1]}, lines);
    }
    return given;
}

/// A head of lines key=value, among them ColumnDef with the names of the columns, then a point a line.
ProfilePoints read_miniprof(std::string_view text, const std::string& name) {
    ProfileLines lines(text, name, "!");
    ProfilePoints given;
    given.mirror_z = true;
    std::size_t columns = 0, x = 0, y = 1;  // 0 columns: as many as there are
    while (lines.next()) {
        const auto line = lines.line();
        if (const auto at = line.find('='); at != line.npos) {
            if (!given.points.empty())
                lines.fail("is " + quoted(line) + " behind points; a file has one profile, its head above the points");
            if (trimmed(line.substr(0, at)) != "ColumnDef") continue;
            const std::string names = "," + std::string(trimmed(line.substr(at + 1))) + ",";
            const auto column_of = [&](const std::string& column) {
                const auto found = names.find("," + column + ",");
                if (found == names.npos)
                    lines.fail("has the columns " + quoted(line.substr(at + 1)) +
                               "; X and Y must be among them, as X,Y");
                return static_cast<std::size_t>(
                    std::count(names.begin(), names.begin() + static_cast<long>(found), ','));
            };
            x = column_of("X"), y = column_of("Y");
            columns = static_cast<std::size_t>(std::count(names.begin(), names.end(), ',')) - 1;
        } else {
            const auto values = lines.numbers(",;");
            if (values.size() < 2 || (columns > 0 && values.size() != columns))
                lines.fail("has " + std::to_string(values.size()) + " numbers; it must have " +
                           (columns > 0 ? std::to_string(columns) + ", as ColumnDef says" : "two at least, X and Y"));
            add_point(given.points, {values[x], values[y]}, lines);
        }
    }
    return given;
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
        return {of_file, simpack ? geometry::read_simpack(text, name, of_file) : geometry::read_miniprof(text, name)};
    }
    if (!kind)
        throw InvalidArgument(name,
                              "does not say by its ending whether it is a wheel's or a rail's (.prw, .prr, .whl, "
                              ".ban do); give the kind");
    return {*kind, geometry::read_columns(text, name)};
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

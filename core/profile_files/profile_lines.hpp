// The lines of a profile's file, and what is wrong with one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// A line after the other, without its end, comments and blanks around it.
class ProfileLines {
   public:
    /// `comments` are the characters with which one begins. Throws InvalidArgument for a text that is not one.
    ProfileLines(std::string_view text, std::string name, std::string_view comments);

    /// Goes to the next line, and false at the end. Throws InvalidArgument for an endless one.
    bool next();
    std::string_view line() const { return line_; }
    /// Returns whether an empty line, which a comment is not, stands before this one.
    bool follows_empty() const { return follows_empty_; }

    /// The numbers of the line, between blanks and the characters of `separators`. Throws for what is none.
    std::vector<double> numbers(std::string_view separators = {}) const;
    /// Value of a text within the line. Throws when it is not a number.
    double number(std::string_view text) const;

    /// Throws InvalidArgument that names file and line. The text of a file goes in by `quoted`.
    [[noreturn]] void fail(const std::string& problem) const;
    /// Throws as fail does, but names the file only.
    [[noreturn]] void fail_file(const std::string& problem) const;

   private:
    std::string_view rest_, comments_, line_;
    std::string name_;
    std::size_t number_ = 0;
    bool follows_empty_ = false;
};

/// The number that the text is as a whole, with a point as decimal sign and an exponent behind e or d; nothing where it
/// is none.
std::optional<double> number_in(std::string_view text);
/// The texts between blanks and the characters of `separators`; two separators have an empty one between them.
std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators);

/// How the numbers of a file are written, as its lines have shown it so far. A comma is a decimal sign where others
/// part the numbers.
struct NumberStyle {
    bool has_decimal_commas = false;

    /// The numbers of a line; nothing where one of its fields is none.
    std::optional<std::vector<double>> numbers(std::string_view line);
};

/// In quotation marks, the first forty characters, without what cannot be printed.
std::string quoted(std::string_view text);
std::string_view trimmed(std::string_view text);
/// Throws when a file has more points than a profile may have.
void add_point(std::vector<ProfilePoint>& points, const ProfilePoint& point, const ProfileLines& lines);

/// Returns the unit in mm that headings and comments above the points state, in brackets or behind "unit" or "in";
/// nothing where they state none. Throws InvalidArgument for two different ones.
std::optional<double> unit_in_heading(std::string_view text, const std::string& name);

/// The points of a file, in its unit and with its own mirroring, and what it leaves open.
struct FilePoints {
    ProfilePoints points;
    bool says_unit = false, says_mirror_z = false;
    bool heading_says_unit = false;  ///< which is believed where it makes a profile of a usual width
    std::size_t lines_left_out = 0;  ///< as of ProfileReading
};

/// Each of the formats. The kind is that of the file's ending.
FilePoints read_simpack(std::string_view text, const std::string& name, ProfileKind kind);
FilePoints read_miniprof(std::string_view text, const std::string& name);
FilePoints read_columns(std::string_view text, const std::string& name);

}  // namespace contactd::geometry

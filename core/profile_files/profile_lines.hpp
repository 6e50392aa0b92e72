// Reads the lines of a profile's file, and reports errors in them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/profile_spec.hpp"

namespace contactd::geometry {

/// Reads one line after the other, without its end, comments and surrounding blanks.
class ProfileLines {
   public:
    /// `comments` are the characters with which comments begin. Throws InvalidArgument for binary data.
    ProfileLines(std::string_view text, std::string name, std::string_view comments);

    /// Goes to the next line; returns false at the end. Throws InvalidArgument for a line that is too long.
    bool next();
    std::string_view line() const { return line_; }
    /// Returns whether an empty line precedes this one; a comment is not an empty line.
    bool follows_empty() const { return follows_empty_; }

    /// Returns the numbers of the line, between blanks and the characters of `separators`. Throws for an invalid
    /// number.
    std::vector<double> numbers(std::string_view separators = {}) const;
    /// Returns the value of a text within the line. Throws if it is not a number.
    double number(std::string_view text) const;

    /// Throws InvalidArgument naming file and line. Texts of a file must be passed through `quoted`.
    [[noreturn]] void fail(const std::string& problem) const;
    /// Throws as fail does, but names the file only.
    [[noreturn]] void fail_file(const std::string& problem) const;

   private:
    std::string_view rest_, comments_, line_;
    std::string name_;
    std::size_t number_ = 0;
    bool follows_empty_ = false;
};

/// Returns the number if the whole text is one, with a decimal point and an exponent after e or d; otherwise nothing.
std::optional<double> number_in(std::string_view text);
/// Returns the texts between blanks and the characters of `separators`; there is an empty one between two separators.
std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators);

/// Describes the format of numbers, as detected in the lines so far. A comma is a decimal sign if other characters
/// separate the numbers.
struct NumberStyle {
    bool has_decimal_commas = false;

    /// Returns the numbers of a line, or nothing if one of its fields is not a number.
    std::optional<std::vector<double>> numbers(std::string_view line);
};

/// Returns the first forty characters in quotation marks, without unprintable ones.
std::string quoted(std::string_view text);
std::string_view trimmed(std::string_view text);
/// Throws if a file has more points than a profile may have.
void add_point(std::vector<ProfilePoint>& points, const ProfilePoint& point, const ProfileLines& lines);

/// Returns the unit in mm that headings and comments above the points state, in brackets or after "unit" or "in", or
/// nothing if they state none. Throws InvalidArgument for two different ones.
std::optional<double> unit_in_heading(std::string_view text, const std::string& name);

/// Holds the points of a file, in its unit and with its own mirroring, and the properties that the file does not
/// define.
struct FilePoints {
    ProfilePoints points;
    bool says_unit = false, says_mirror_z = false;
    bool heading_says_unit = false;  ///< which is used if the resulting width is usual for a profile
    std::size_t lines_left_out = 0;  ///< as of ProfileReading
};

/// These functions read the formats. The kind is that of the file's extension.
FilePoints read_simpack(std::string_view text, const std::string& name, ProfileKind kind);
FilePoints read_miniprof(std::string_view text, const std::string& name);
FilePoints read_columns(std::string_view text, const std::string& name);

}  // namespace contactd::geometry

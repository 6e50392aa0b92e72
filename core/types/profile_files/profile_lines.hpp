// The lines of a profile's file, and what is wrong with one.
#pragma once

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

/// In quotation marks, the first forty characters, without what cannot be printed.
std::string quoted(std::string_view text);
std::string_view trimmed(std::string_view text);
/// Throws when a file has more points than a profile may have.
void add_point(std::vector<ProfilePoint>& points, const ProfilePoint& point, const ProfileLines& lines);

/// Each of the formats. The kind is that of the file's ending.
ProfilePoints read_simpack(std::string_view text, const std::string& name, ProfileKind kind);
ProfilePoints read_miniprof(std::string_view text, const std::string& name, ProfileKind kind);
ProfilePoints read_columns(std::string_view text, const std::string& name, ProfileKind kind);

}  // namespace contactd::geometry

#include "profile_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "contactd/error.hpp"

namespace contactd::geometry {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";
constexpr std::size_t longest_line = 4096;

}  // namespace

std::string quoted(std::string_view text) {
    std::string shown;
    for (const char c : text.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
    return '"' + shown + (text.size() > 40 ? "...\"" : "\"");
}

std::string_view trimmed(std::string_view text) {
    const auto from = text.find_first_not_of(blanks);
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

ProfileLines::ProfileLines(std::string_view text, std::string name, std::string_view comments)
    : rest_(text), comments_(comments), name_(std::move(name)) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    if (rest_.find('\0') != rest_.npos)
        fail_file("is not a text file, because it contains zero bytes; export the profile as plain text");
}

std::optional<double> number_in(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    std::string digits(text);
    if (const auto at = digits.find_first_of("dD"); at != digits.npos) digits[at] = 'e';  // as Fortran writes it
    double value = 0;
    const char* const whole = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), whole, value);
    if (digits.empty() || error != std::errc() || end != whole || !(std::abs(value) <= 1e100)) return {};
    return value;
}

bool ProfileLines::next() {
    follows_empty_ = false;
    while (!rest_.empty()) {
        ++number_;
        const auto end = std::min(rest_.find('\n'), rest_.size());
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (line_.size() > longest_line)
            fail("has " + std::to_string(line_.size()) +
                 " characters; give each point on its own line of at most 4096 characters");
        if (trimmed(line_).empty()) follows_empty_ = true;
        line_ = trimmed(line_.substr(0, line_.find_first_of(comments_)));
        if (!line_.empty()) return true;
    }
    return false;
}

double ProfileLines::number(std::string_view text) const {
    const auto value = number_in(text);
    if (!value) fail("has " + quoted(text) + " instead of a number such as -12.5 or 1.25e-3");
    return *value;
}

std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators) {
    std::vector<std::string_view> found;
    const std::string ends = std::string(blanks) + std::string(separators);
    std::string_view rest = line;
    while (!(rest = trimmed(rest)).empty()) {
        const auto end = std::min(rest.find_first_of(ends), rest.size());
        found.push_back(rest.substr(0, end));
        rest = trimmed(rest.substr(end));
        if (!rest.empty() && separators.find(rest.front()) != separators.npos) rest.remove_prefix(1);
    }
    return found;
}

std::optional<std::vector<double>> NumberStyle::numbers(std::string_view line) {
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

std::vector<double> ProfileLines::numbers(std::string_view separators) const {
    std::vector<double> values;
    for (const std::string_view field : fields_of(line_, separators)) values.push_back(number(field));
    return values;
}

void ProfileLines::fail(const std::string& problem) const {
    throw InvalidArgument(name_ + ", line " + std::to_string(number_) + ",", problem);
}

void ProfileLines::fail_file(const std::string& problem) const {
    throw InvalidArgument(name_, problem);
}

void add_point(std::vector<ProfilePoint>& points, const ProfilePoint& point, const ProfileLines& lines) {
    if (points.size() == most_profile_points)
        lines.fail("exceeds the limit of " + std::to_string(most_profile_points) +
                   " points of a profile; omit some of them");
    points.push_back(point);
}

}  // namespace contactd::geometry

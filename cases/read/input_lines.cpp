#include "input_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/read_contact_file.hpp"
#include "profile_files/profile_lines.hpp"

namespace contactd::contact_files {
namespace {

constexpr std::size_t longest_line = 256;
constexpr std::string_view separators = " \t\r,=";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Returns the end of the digits that begin at `at`.
std::size_t past_digits(std::string_view word, std::size_t at) {
    while (at < word.size() && is_digit(word[at])) ++at;
    return at;
}

std::size_t past_sign(std::string_view word, std::size_t at) {
    return at < word.size() && (word[at] == '+' || word[at] == '-') ? at + 1 : at;
}

/// Converts a real to the syntax of from_chars. Returns an empty string for an invalid word.
std::string plain_real(std::string_view word) {
    const std::size_t whole = past_sign(word, 0);
    std::size_t at = past_digits(word, whole), digits = at - whole;
    if (at < word.size() && word[at] == '.') {
        const std::size_t end = past_digits(word, at + 1);
        digits += end - at - 1;
        at = end;
    }
    if (digits == 0) return {};
    std::string plain(word.substr(word.starts_with('+') ? 1 : 0, at - (word.starts_with('+') ? 1 : 0)));
    if (at == word.size()) return plain;
    const bool has_letter = std::string_view("eEdD").find(word[at]) != std::string_view::npos;
    if (!has_letter && past_sign(word, at) == at) return {};
    const std::size_t sign = has_letter ? at + 1 : at, power = past_sign(word, sign);
    if (power == word.size() || past_digits(word, power) != word.size()) return {};
    return plain + 'e' + std::string(word.substr(word[sign] == '+' ? power : sign));
}

}  // namespace

std::optional<double> real_in(std::string_view word) {
    const std::string plain = plain_real(word);
    double value = 0;
    const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (plain.empty() || error != std::errc() || end != plain.data() + plain.size()) return {};
    return value;
}

std::optional<double> angle_in(std::string_view word) {
    if (const auto value = real_in(word)) return value;
    if (word.empty()) return {};
    const char letter = word.back();
    const auto value = real_in(word.substr(0, word.size() - 1));
    if (!value || std::string_view("dDrR").find(letter) == std::string_view::npos) return {};
    return letter == 'd' || letter == 'D' ? *value * std::numbers::pi / 180 : *value;
}

std::optional<int> integer_in(std::string_view word) {
    const std::size_t from = past_sign(word, 0), end = past_digits(word, from);
    if (end == from) return {};
    const std::string_view behind = word.substr(end);
    if (!behind.empty() && (behind[0] != '.' || behind.find_first_not_of('0', 1) != behind.npos)) return {};
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0, end - (word.starts_with('+') ? 1 : 0));
    int value = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc()) return {};
    return value;
}

InputLines::InputLines(std::string_view text, const std::string& name, const Observer* observer)
    : rest_(text), observer_(observer) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    if (text.size() > most_contact_file_bytes)
        throw InvalidArgument(name, "has " + std::to_string(text.size()) +
                                        " bytes; an input file of CONTACT may have at most " +
                                        std::to_string(most_contact_file_bytes) + ": divide the file");
    if (rest_.find('\0') != rest_.npos)
        throw InvalidArgument(
            name, "is not a text file, because it contains zero bytes; give an input file of CONTACT (.inp)");
}

bool InputLines::next() {
    while (!rest_.empty()) {
        constexpr std::size_t lines_between_looks = 1024;
        if (++number_ % lines_between_looks == 0 && observer_ != nullptr) observer_->throw_if_cancelled();
        const auto end = std::min(rest_.find('\n'), rest_.size());
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        what_is_cut_ = line.size() > longest_line ? "has more than 256 characters" : nullptr;
        line = line.substr(0, longest_line);
        // CONTACT ignores quotation marks when it looks for empty lines.
        if (line.substr(0, line.find('%')).find_first_not_of(" \t\r") == line.npos) continue;
        split(line);
        if (!words_.empty()) return true;
    }
    words_.clear();
    return false;
}

void InputLines::advance(const std::string& what) {
    if (!next()) fail_line("is the end of the file, but " + what + " must follow");
}

void InputLines::split(std::string_view line) {
    words_.clear();
    std::size_t at = 0;
    while (at < line.size() && line[at] != '%') {
        if (separators.find(line[at]) != separators.npos) {
            ++at;
            continue;
        }
        if (words_.size() == most_words_of_array) {
            what_is_cut_ = "has more than 50 words";
            return;
        }
        Word word{.column = at + 1, .is_quoted = line[at] == '\''};
        std::size_t end;
        if (word.is_quoted) {
            end = line.find('\'', at + 1);
            word.is_open = end == line.npos;
            end = std::min(end, line.size());
            word.text = line.substr(at + 1, end - at - 1);
            std::ranges::replace(word.text, ',', ' ');
            end = std::min(end + 1, line.size());
        } else {
            end = std::min(line.find_first_of(" \t\r,=%'", at), line.size());
            word.text = line.substr(at, end - at);
        }
        words_.push_back(std::move(word));
        at = end;
    }
}

void InputLines::fail(const Word& word, const std::string& problem) const {
    throw InvalidArgument(where() + ", column " + std::to_string(word.column) + ",", problem);
}

void InputLines::fail_line(const std::string& problem) const {
    throw InvalidArgument(where(), problem);
}

}  // namespace contactd::contact_files

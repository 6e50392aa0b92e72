#include "case_digits.hpp"

#include <array>
#include <string>

#include "profile_files/profile_lines.hpp"

namespace contactd::contact_files {
namespace {

struct DigitRule {
    std::string_view name;
    std::string_view on_rails, alone;  ///< allowed values in modules 1 and 3; all digits if empty
};

constexpr std::array first_word{DigitRule{"C1", "0145", ""},       DigitRule{"P", "0123", "0123"},
                                DigitRule{"B", "0156", "0123456"}, DigitRule{"T", "0123", "0123"},
                                DigitRule{"N", "01", "01"},        DigitRule{"F", "013", "012"},
                                DigitRule{"S", "0123", "0123"}};
constexpr std::array second_word{
    DigitRule{"V", "012", "03"},       DigitRule{"L", "012346", "012346"},     DigitRule{"D", "0123456789", "012"},
    DigitRule{"C", "01234", "012349"}, DigitRule{"M", "01234567", "01234567"}, DigitRule{"Z", "0123", "012"},
    DigitRule{"E", "012345", "01239"}};
constexpr std::array third_word{
    DigitRule{"X", "01", "01"},     DigitRule{"H", "013", "013"},  DigitRule{"G", "012345", "012345"},
    DigitRule{"I", "0123", "0123"}, DigitRule{"A", "012", "012"},  DigitRule{"O", "012345", "012345"},
    DigitRule{"W", "", ""},         DigitRule{"R", "0123", "0123"}};

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

/// Returns the first word of the line as digits, padded with zeros on the left.
std::string digits_here(const InputLines& lines, std::string_view names, std::size_t most, std::size_t count) {
    const std::string expected = "where the control digits " + std::string(names) + " are expected";
    const Word& word = lines.words().front();
    if (word.is_quoted || !is_number(word.text))
        lines.fail(word, "has " + geometry::quoted(word.text) + " " + expected);
    if (word.text.size() > most)
        lines.fail(word, "has " + std::to_string(word.text.size()) + " digits " + expected + ", which are at most " +
                             std::to_string(most));
    const std::size_t length = word.text.size();
    return length < count ? std::string(count - length, '0') + word.text : word.text;
}

std::string next_digits(InputLines& lines, std::string_view names, std::size_t most, std::size_t count) {
    lines.advance("the control digits " + std::string(names));
    return digits_here(lines, names, most, count);
}

template <std::size_t count>
void take(const InputLines& lines, ContactCase& read, const std::array<DigitRule, count>& rules,
          std::string_view digits) {
    digits.remove_prefix(digits.size() - count);
    for (std::size_t i = 0; i < count; ++i) {
        const DigitRule& rule = rules[i];
        const std::string_view allowed = read.module_number == 1 ? rule.on_rails : rule.alone;
        if (!allowed.empty() && allowed.find(digits[i]) == allowed.npos) {
            std::string words;
            for (const char c : allowed) words += (words.empty() ? "" : ", ") + std::string(1, c);
            lines.fail(lines.words().front(), "has the digit " + std::string(rule.name) + " = " + digits[i] +
                                                  "; in module " + std::to_string(read.module_number) +
                                                  " it must be one of " + words);
        }
        if (rule.name != "C1" || read.module_number == 1) read.digits[std::string(rule.name)] = digits[i] - '0';
    }
}

/// Reads M2, preceded by an optional W2, which follows the second control word on the same line.
void take_damping(const InputLines& lines, ContactCase& read) {
    int damping = 1, weight = 0;
    if (lines.words().size() > 1 && !lines.words()[1].is_quoted) {
        const Word& word = lines.words()[1];
        if (const auto value = integer_in(word.text)) {
            damping = *value % 10, weight = *value / 10;
            if (*value < 0 || damping > 2 || weight > 1)
                lines.fail(word, "has " + geometry::quoted(word.text) +
                                     " where M2 (0, 1 or 2) is expected, optionally preceded by W2 (0 or 1)");
        }
    }
    read.digits["M2"] = damping;
    read.digits["W2"] = weight;
}

}  // namespace

void read_digits(InputLines& lines, ContactCase& read) {
    take(lines, read, first_word, digits_here(lines, read.module_number == 1 ? "C1 P B T N F S" : "P B T N F S", 7, 7));
    take(lines, read, second_word, next_digits(lines, "V L D C M Z E", 7, 7));
    take_damping(lines, read);
    take(lines, read, third_word, next_digits(lines, "X H G I A O W R", 8, 8));
    if (digit(read, "X") == 1) next_digits(lines, "P S F L C I N R of debug output", 8, 7);
}

int digit(const ContactCase& read, std::string_view name) {
    const auto found = read.digits.find(name);
    return found == read.digits.end() ? 0 : found->second;
}

}  // namespace contactd::contact_files

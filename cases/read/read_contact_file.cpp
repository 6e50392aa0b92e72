#include "contactd/read_contact_file.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "case_digits.hpp"
#include "case_rules.hpp"
#include "contactd/error.hpp"
#include "profile_files/profile_lines.hpp"
#include "steps.hpp"

namespace contactd {
namespace contact_files {

/// Identifies the memory of a case: module, result element and contact problem, which are 0 if they are not given.
using HistoryKey = std::tuple<int, int, int>;

/// Holds the content of a MODULE line.
struct ModuleLine {
    int module = 0;
    std::optional<int> reid, cpid;
};

}  // namespace contact_files

namespace {

using namespace contact_files;

constexpr std::size_t most_errors = 100;  // largest number of errors between cases, after which reading ends

bool says_module(const Word& word) {
    constexpr std::string_view module = "module";
    return !word.is_quoted && std::ranges::equal(std::string_view(word.text).substr(0, module.size()), module, {},
                                                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
}

ModuleLine module_line(const InputLines& lines) {
    ModuleLine line;
    const auto& words = lines.words();
    const auto number = [&](std::size_t at) {
        return at < words.size() && !words[at].is_quoted ? integer_in(words[at].text) : std::nullopt;
    };
    const auto module = number(0);
    if (!module || (*module != 0 && *module != 1 && *module != 3))
        lines.fail(words[0], "has " + geometry::quoted(words[0].text) +
                                 " where the number of a MODULE is expected: 1, 3, or 0 at the end of the cases");
    line.module = *module;
    if (line.module == 0 || !(line.reid = number(1))) return line;
    line.cpid = number(2);
    if (*line.reid < 1 || *line.reid > 999)
        lines.fail(words[1], "has " + geometry::quoted(words[1].text) +
                                 " where a result element, REID, from 1 to 999 is expected");
    if (line.cpid && (*line.cpid < 1 || *line.cpid > 9))
        lines.fail(words[2], "has " + geometry::quoted(words[2].text) +
                                 " where a contact problem, CPID, from 1 to 9 is expected");
    if (line.module == 3 && !line.cpid) line.cpid = 1;
    return line;
}

}  // namespace

struct ContactFileReader::State {
    InputLines lines;
    std::vector<std::string> warnings{}, errors{};
    std::map<HistoryKey, History> histories{};
    std::map<int, int> counters{};  ///< number of cases for each result element
    ModuleLine module{};
    bool is_open = false;  ///< whether the next case follows without a MODULE line
    bool is_lost = false;  ///< whether reading of a case was aborted
    bool has_ended = false;

    /// Goes to the first control word of the next case. Returns false if there is none.
    bool find_case();
    /// Goes to the first control word after a MODULE line. Returns false at the end of the file.
    bool begin_case();
    /// Goes to the next MODULE line after an error, and reads it. `may_be_this`: this line may be one, too.
    bool find_module(bool may_be_this);
    /// Reads a MODULE line. Returns false for module 0.
    bool take_module();
    ContactCase read_case();
};

bool ContactFileReader::State::take_module() {
    module = module_line(lines);
    if (module.module != 0) return true;
    has_ended = true;
    const auto line = lines.number();
    if (lines.next())
        warnings.push_back("line " + std::to_string(line) + " ends the cases with MODULE 0; line " +
                           std::to_string(lines.number()) + " and all that follow are ignored");
    return false;
}

bool ContactFileReader::State::find_module(bool may_be_this) {
    while (may_be_this || lines.next()) {
        may_be_this = false;
        const auto& words = lines.words();
        if (words.empty() || !std::any_of(words.begin() + 1, words.end(), says_module)) continue;
        try {
            return take_module();
        } catch (const InvalidArgument& problem) {
            errors.push_back(problem.what());
        }
        if (errors.size() == most_errors) break;
    }
    has_ended = true;
    return false;
}

bool ContactFileReader::State::find_case() {
    if (is_open) {
        if (lines.next()) return true;
        errors.push_back(lines.where() +
                         " is the end of the file, but R = 0 or 2 of the last case requires another one");
        has_ended = true;
        return false;
    }
    if (std::exchange(is_lost, false)) return find_module(true) && begin_case();
    if (!lines.next()) {
        if (counters.empty() && errors.empty())
            errors.push_back("there is no case, only comments and empty lines");
        else
            warnings.push_back(lines.where() +
                               " is the end of the file, without a line of MODULE 0; the file may be truncated");
        has_ended = true;
        return false;
    }
    try {
        if (!take_module()) return false;
    } catch (const InvalidArgument& problem) {
        errors.push_back(problem.what());
        if (!find_module(false)) return false;
    }
    return begin_case();
}

bool ContactFileReader::State::begin_case() {
    if (lines.next()) return true;
    errors.push_back(lines.where() + " is the end of the file, but a case must follow");
    has_ended = true;
    return false;
}

ContactCase ContactFileReader::State::read_case() {
    const HistoryKey key{module.module, module.reid.value_or(0), module.cpid.value_or(0)};
    const auto [found, is_new] = histories.try_emplace(key);
    History& history = found->second;
    if (is_new) history = new_history(module.module);
    ContactCase result;
    result.values = history.last.values;
    result.friction = history.last.friction;
    result.subsurface = history.last.subsurface;
    result.module_number = module.module;
    result.reid = module.reid;
    result.cpid = module.cpid;
    result.number = ++counters[module.reid.value_or(0)];
    result.line = lines.number();
    Reading reading{lines, result};
    try {
        read_digits(lines, result);
        apply_digits(reading, history);
        read_steps(reading, module.module == 1 ? steps_on_rails() : steps_alone());
        apply_values(reading);
        if (keeps_nothing(reading)) history.torn = 0;
        is_open = digit(result, "R") % 2 == 0;
        history.last = result;
        ++history.cases;
    } catch (const InvalidArgument& problem) {
        const bool is_early = std::ranges::any_of(lines.words(), says_module);
        result.errors.push_back(problem.what() +
                                std::string(is_early ? "; a case before this line may be truncated" : ""));
        history.torn = result.number;
        is_lost = true;
        is_open = false;
    }
    history.failed = result.errors.empty() ? 0 : result.number;
    return result;
}

ContactFileReader::ContactFileReader(std::string_view text, const std::string& name, const Observer* observer)
    : state_(new State{.lines = InputLines(text, name, observer)}) {}

ContactFileReader::~ContactFileReader() = default;

std::optional<ContactCase> ContactFileReader::next() {
    State& state = *state_;
    if (state.has_ended || !state.find_case()) return {};
    return state.read_case();
}

const std::vector<std::string>& ContactFileReader::warnings() const {
    return state_->warnings;
}

const std::vector<std::string>& ContactFileReader::errors() const {
    return state_->errors;
}

ContactFile read_contact_file(std::string_view text, const std::string& name) {
    ContactFileReader reader(text, name);
    ContactFile file;
    while (auto read = reader.next()) {
        if (file.cases.size() == most_contact_cases)
            throw InvalidArgument(name, "has more than " + std::to_string(most_contact_cases) +
                                            " cases; read them one by one (ContactFileReader)");
        file.cases.push_back(std::move(*read));
    }
    file.warnings = reader.warnings();
    file.errors = reader.errors();
    return file;
}

}  // namespace contactd

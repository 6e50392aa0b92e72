#include "groups.hpp"

#include <utility>

#include "case_digits.hpp"
#include "profile_files/profile_lines.hpp"

namespace contactd::contact_files {
namespace {

constexpr std::size_t most_warnings = 20;  // largest number of warnings of a case, and of errors

/// Holds the specification of a value of a group.
struct Item {
    std::string_view name;
    char kind = ' ';  ///< #, ^, ' or a blank
    std::string_view fallback{};
};

Item item_of(std::string_view text) {
    Item item;
    const auto equals = text.find('=');
    if (equals != text.npos) item.fallback = text.substr(equals + 1);
    item.name = text.substr(0, equals);
    if (std::string_view("#^'").find(item.name.back()) != std::string_view::npos) {
        item.kind = item.name.back();
        item.name.remove_suffix(1);
    }
    return item;
}

std::optional<ContactValue> value_of(const Item& item, const Word& word) {
    if (word.is_open || word.is_quoted != (item.kind == '\'')) return {};
    if (item.kind == '\'') return word.text;
    if (item.kind == '#') {
        if (const auto value = integer_in(word.text)) return *value;
    } else if (const auto value = item.kind == '^' ? angle_in(word.text) : real_in(word.text)) {
        return *value;
    }
    return {};
}

const char* kind_of(const Item& item) {
    switch (item.kind) {
        case '#':
            return ", an integer such as 12,";
        case '^':
            return ", an angle such as 30d or 0.52,";
        case '\'':
            return ", a name in single quotation marks,";
        default:
            return ", a number such as 0.5 or 1e-3,";
    }
}

/// Reads the words of a group, from the current line and the following ones.
class WordsOfGroup {
   public:
    WordsOfGroup(Reading& reading, std::size_t most) : reading_(reading), most_(most) {}

    const Word& next(const std::string& what) {
        while (at_ == count_) {
            warn_of_cut();
            reading_.lines.advance(what);
            at_ = 0, count_ = std::min(reading_.lines.words().size(), most_);
        }
        return reading_.lines.words()[at_++];
    }
    /// Returns the next word on this line, or null if there is none.
    const Word* next_here() { return at_ == count_ ? nullptr : &reading_.lines.words()[at_++]; }
    /// Warns of a number after the last value, which CONTACT ignores. An earlier value may be surplus.
    void end() const {
        if (at_ == count_) return;
        const Word& word = reading_.lines.words()[at_];
        if (!word.is_quoted && real_in(word.text))
            reading_.warn("has the number " + geometry::quoted(word.text) + " in column " +
                          std::to_string(word.column) + " after the last value of its group, which is ignored");
    }

   private:
    void warn_of_cut() const {
        if (count_ > 0 && reading_.lines.what_is_cut())
            reading_.warn(std::string(reading_.lines.what_is_cut()) +
                          "; the rest is ignored, and the values continue in the next line");
    }

    Reading& reading_;
    std::size_t most_, at_ = 0, count_ = 0;
};

/// Reads the optional values that are present. With `together`, they are only used if all are present.
void read_optional(Reading& reading, WordsOfGroup& words, std::vector<Item> items, bool together,
                   ByName<ContactValue>& values) {
    std::size_t taken = 0;
    for (; taken < items.size(); ++taken) {
        const Word* word = words.next_here();
        if (!word) break;
        const auto value = value_of(items[taken], *word);
        if (!value) {
            if (real_in(word->text))
                reading.warn("has " + geometry::quoted(word->text) + " where the optional integer " +
                             std::string(items[taken].name) + " is expected; it is taken as a comment");
            break;
        }
        values[std::string(items[taken].name)] = *value;
    }
    if (taken == items.size()) words.end();
    if (together && taken > 0 && taken < items.size()) {
        reading.warn("has " + std::string(items[0].name) + " without " + std::string(items[taken].name) +
                     "; give both, because a single one is ignored");
        taken = 0;
    }
    for (; taken < items.size(); ++taken) {
        values.erase(std::string(items[taken].name));
        if (!items[taken].fallback.empty())
            values[std::string(items[taken].name)] =
                *value_of(items[taken], Word{.text = std::string(items[taken].fallback)});
    }
}

}  // namespace

int Reading::digit(std::string_view name) const {
    return contact_files::digit(result, name);
}

int Reading::integer(std::string_view name) const {
    const auto found = result.values.find(name);
    const int* value = found == result.values.end() ? nullptr : std::get_if<int>(&found->second);
    return value ? *value : 0;
}

double Reading::real(std::string_view name) const {
    const auto found = result.values.find(name);
    const double* value = found == result.values.end() ? nullptr : std::get_if<double>(&found->second);
    return value ? *value : 0;
}

void Reading::set(std::string_view name, ContactValue value) {
    result.values[std::string(name)] = std::move(value);
}

void Reading::forget(std::string_view names) {
    for (const std::string_view name : geometry::fields_of(names, "")) {
        const auto found = result.values.find(name);
        if (found != result.values.end()) result.values.erase(found);
    }
}

void Reading::take(std::string_view name, ContactValue value) {
    result.read.emplace_back(name);
    set(name, std::move(value));
}

void Reading::warn(const std::string& sentence) {
    if (result.warnings.size() < most_warnings) result.warnings.push_back(lines.where() + " " + sentence);
}

void Reading::fail_case(const std::string& sentence) {
    if (result.errors.size() < most_warnings) result.errors.push_back(lines.where() + " " + sentence);
}

ByName<ContactValue> read_values(Reading& reading, std::string_view group) {
    const auto brace = group.find('{');
    ByName<ContactValue> values;
    WordsOfGroup words(reading, most_words);
    for (const std::string_view text : geometry::fields_of(group.substr(0, brace), "")) {
        const Item item = item_of(text);
        const std::string name(item.name);
        const Word& word = words.next(name);
        auto value = value_of(item, word);
        if (!value)
            reading.lines.fail(word, "has " + geometry::quoted(word.text) + " where " + name + kind_of(item) +
                                         " is expected" + (word.is_open ? "; a quotation mark is missing" : ""));
        values[name] = std::move(*value);
    }
    if (brace == group.npos) {
        words.end();
        return values;
    }
    std::string_view optional = group.substr(brace + 1, group.find('}') - brace - 1);
    const bool together = optional.starts_with('+');
    if (together) optional.remove_prefix(1);
    std::vector<Item> items;
    for (const std::string_view text : geometry::fields_of(optional, "")) items.push_back(item_of(text));
    read_optional(reading, words, std::move(items), together, values);
    return values;
}

void read_group(Reading& reading, std::string_view group) {
    ByName<ContactValue> values = read_values(reading, group);
    for (auto& [name, value] : values) reading.take(name, std::move(value));
}

std::vector<double> read_array(Reading& reading, std::string_view what, std::size_t count, std::string_view kinds) {
    const std::string name(what);
    WordsOfGroup words(reading, most_words_of_array);
    std::vector<double> values;
    while (values.size() < count) {
        const std::string which = "value " + std::to_string(values.size() + 1) + " of " + name;
        const Word& word = words.next(which);
        const Item item{.name = which, .kind = kinds[values.size() % kinds.size()]};
        const auto value = value_of(item, word);
        if (!value)
            reading.lines.fail(
                word, "has " + geometry::quoted(word.text) + " where " + which + kind_of(item) + " is expected");
        values.push_back(std::holds_alternative<int>(*value) ? std::get<int>(*value) : std::get<double>(*value));
    }
    words.end();
    return values;
}

std::vector<double> column_of(const std::vector<double>& array, std::size_t column, std::size_t columns) {
    std::vector<double> values;
    values.reserve(array.size() / columns);
    for (std::size_t i = column; i < array.size(); i += columns) values.push_back(array[i]);
    return values;
}

ContactNumbers shared(std::vector<double> numbers) {
    return std::make_shared<const std::vector<double>>(std::move(numbers));
}

}  // namespace contactd::contact_files

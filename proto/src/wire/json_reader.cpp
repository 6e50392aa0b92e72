#include "contactd/proto/json_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "contactd/proto/status.hpp"
#include "schema/shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

bool is_letter_or_sign(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+';
}

/// Returns the token of a number that is not finite at `at`, such as "NaN" or "-Infinity" of other languages; otherwise
/// an empty text.
std::string_view non_finite_token(std::string_view text, std::size_t at) {
    if (!is_letter_or_sign(text[at])) return {};
    std::size_t begin = at, end = at;
    while (begin > 0 && is_letter_or_sign(text[begin - 1])) --begin;
    while (end < text.size() && is_letter_or_sign(text[end])) ++end;
    const std::string_view found = text.substr(begin, end - begin);
    std::string token(found);
    std::erase_if(token, [](char c) { return c == '-' || c == '+'; });
    std::transform(token.begin(), token.end(), token.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    const bool known = token == "nan" || token == "inf" || token == "infinity";
    return known ? found : std::string_view{};
}

/// Builds the document from the parser's events.
class EventReader : public nlohmann::json_sax<json> {
   public:
    EventReader(std::string_view text, std::size_t max_values, json& root, std::string_view what)
        : text_(text), max_values_(max_values), root_(root), what_(what) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override {
        // The number is kept as a signed integer or a double, so that no later reader sees it wrapped around.
        constexpr auto largest = static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max());
        return value <= largest ? put(value) : put(static_cast<double>(value));
    }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(json::object()); }
    bool key(string_t& name) override {
        open_.back().key = std::move(name);
        return true;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t position, const std::string& token, const json::exception& problem) override {
        if (text_.empty()) fail(reason::not_json, "is empty; it must be a JSON object");
        const std::size_t last = std::min(position, text_.size()) - (position > 0 ? 1 : 0);
        if (const auto number = non_finite_token(text_, last); !number.empty()) refuse_number(number);
        if (problem.id == number_overflow) refuse_number(token);
        std::string detail = problem.what();
        if (const auto at = detail.find(": "); at != std::string::npos) detail.erase(0, at + 2);
        fail(reason::not_json, "is not JSON at byte " + std::to_string(position) + ": " + shortened(detail, 200));
    }

   private:
    static constexpr int number_overflow = 406;  // code of nlohmann::json::out_of_range

    struct Open {
        json* value;
        std::string key;
    };

    json* insert(json value) {
        if (++values_ > max_values_)
            fail(reason::limit_exceeded, "contains more than " + std::to_string(max_values_) +
                                             " values; send large arrays as frames, within the limits of server.info");
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        json& parent = *open_.back().value;
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        // RFC 8259 leaves the meaning of a repeated key to its readers, which differ: see RFC 7493, 2.3.
        const auto [member, is_new] = parent.get_ref<json::object_t&>().try_emplace(open_.back().key, std::move(value));
        if (!is_new) refuse_repetition();
        return &member->second;
    }

    bool put(json value) {
        insert(std::move(value));
        if (!open_.empty()) open_.back().key.clear();
        return true;
    }

    bool open(json container) {
        if (open_.size() >= max_depth)
            fail(reason::not_json, "is nested more than " + std::to_string(max_depth) + " levels deep");
        open_.push_back({insert(std::move(container)), {}});
        return true;
    }

    bool close() {
        open_.pop_back();
        if (!open_.empty()) open_.back().key.clear();
        return true;
    }

    /// Returns the path of the field being read, relative to "params" if it is below; empty outside any field.
    std::string field() const {
        std::string path;
        for (const Open& level : open_) {
            // An entry that is itself a list or an object is already in its list; any other entry is not.
            const bool innermost = &level == &open_.back();
            if (level.value->is_array())
                path += "[" + std::to_string(level.value->size() - (innermost ? 0 : 1)) + "]";
            else if (!level.key.empty())
                path += (path.empty() ? "" : ".") + shortened(level.key);
            if (path.size() > 4 * max_shown) break;
        }
        constexpr std::string_view below = "params.";
        return path.starts_with(below) ? path.substr(below.size()) : path;
    }

    [[noreturn]] void refuse_number(std::string_view number) const {
        const std::string problem =
            "is " + shortened(number) + "; every number must be finite and representable as a double";
        if (field().empty()) fail(reason::not_json, problem);
        throw invalid_field(field(), problem, reason::not_json);
    }

    [[noreturn]] void refuse_repetition() const {
        throw invalid_field(field(), "is given twice; keys of an object must be unique", reason::not_json);
    }

    /// Reports an error that concerns the whole envelope, found at the field being read.
    [[noreturn]] void fail(std::string_view why, const std::string& problem) const {
        Status status{StatusCode::invalid_argument, std::string(what_) + " " + problem + ".", std::string(why), {}, 0};
        if (std::string name = field(); !name.empty()) status.violations.push_back({std::move(name), problem});
        throw StatusError(std::move(status));
    }

    std::string_view text_;
    std::size_t max_values_;
    std::size_t values_ = 0;
    json& root_;
    std::string_view what_;
    std::vector<Open> open_;
};

}  // namespace

void read_json(std::string_view text, std::size_t max_values, json& root, std::string_view what) {
    root = json();
    EventReader reader(text, max_values, root, what);
    json::sax_parse(text.begin(), text.end(), &reader);
}

}  // namespace contactd::proto

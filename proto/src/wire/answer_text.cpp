#include "contactd/proto/answer_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "contactd/error.hpp"

namespace contactd::proto {

using nlohmann::json;

/// Parses one document; each part returns false if the text is not JSON.
class AnswerParser {
   public:
    AnswerParser(std::string_view text, AnswerText& result)
        : at_(text.data()), end_(text.data() + text.size()), result_(result) {
        result_.nodes_.reserve(text.size() / 8);
    }

    bool document() {
        skip("\xef\xbb\xbf");  // a byte order mark, which UTF-8 does not need
        skip_space();
        if (!value(0)) return false;
        skip_space();
        return at_ == end_;
    }

   private:
    using Node = AnswerText::Node;
    static constexpr int deepest = 256;

    void skip_space() {
        while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
    }
    bool skip(char c) {
        skip_space();
        if (at_ == end_ || *at_ != c) return false;
        ++at_;
        return true;
    }
    bool skip(std::string_view expected) {
        if (std::string_view(at_, static_cast<std::size_t>(end_ - at_)).substr(0, expected.size()) != expected)
            return false;
        at_ += expected.size();
        return true;
    }

    Node& node(JsonKind kind) {
        Node& made = result_.nodes_.emplace_back();
        made.kind = kind;
        made.end = static_cast<std::uint32_t>(result_.nodes_.size());
        return made;
    }

    bool value(int depth) {
        if (at_ == end_ || depth > deepest) return false;
        switch (*at_) {
            case '{':
                return group(JsonKind::object, '}', depth);
            case '[':
                return group(JsonKind::list, ']', depth);
            case '"':
                return text();
            case 't':
                node(JsonKind::boolean).flag = true;
                return skip("true");
            case 'f':
                node(JsonKind::boolean).flag = false;
                return skip("false");
            case 'n':
                node(JsonKind::null);
                return skip("null");
            default:
                return number();
        }
    }

    bool group(JsonKind kind, char close, int depth) {
        ++at_;
        const std::size_t place = result_.nodes_.size();
        node(kind);
        std::uint32_t size = 0;
        if (!skip(close)) {
            do {
                skip_space();
                if (kind == JsonKind::object && !name()) return false;
                skip_space();
                if (!value(depth + 1)) return false;
                ++size;
            } while (skip(','));
            if (!skip(close)) return false;
        }
        result_.nodes_[place].size = size;
        result_.nodes_[place].end = static_cast<std::uint32_t>(result_.nodes_.size());
        return true;
    }

    bool name() { return at_ != end_ && *at_ == '"' && text() && skip(':'); }

    // --- numbers -----------------------------------------------------------------------------------------------------
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    bool digits() {
        const char* begin = at_;
        while (at_ != end_ && is_digit(*at_)) ++at_;
        return at_ != begin;
    }

    bool number() {
        const char* begin = at_;
        if (*at_ == '-') ++at_;
        if (at_ == end_) return false;
        if (*at_ == '0')
            ++at_;
        else if (!digits())
            return false;
        bool whole = true;
        if (at_ != end_ && *at_ == '.') {
            whole = false;
            ++at_;
            if (!digits()) return false;
        }
        if (at_ != end_ && (*at_ == 'e' || *at_ == 'E')) {
            whole = false;
            ++at_;
            if (at_ != end_ && (*at_ == '+' || *at_ == '-')) ++at_;
            if (!digits()) return false;
        }
        if (whole) {
            std::int64_t integer = 0;
            if (std::from_chars(begin, at_, integer).ec == std::errc{}) {
                node(JsonKind::integer).integer = integer;
                return true;
            }
        }
        return fraction({begin, static_cast<std::size_t>(at_ - begin)});
    }

    bool fraction(std::string_view token) {
        double number = 0;
        if (std::from_chars(token.data(), token.data() + token.size(), number).ec != std::errc{}) {
            // The number is either too large for a double, which is an error, or too small, which counts as zero.
            const json other = json::parse(token, nullptr, false);
            if (!other.is_number()) return false;
            number = other.get<double>();
        }
        if (!std::isfinite(number)) return false;
        node(JsonKind::number).number = number;
        return true;
    }

    // --- texts -------------------------------------------------------------------------------------------------------
    bool text() {
        const char* begin = ++at_;
        while (at_ != end_ && *at_ != '"' && *at_ != '\\' && static_cast<unsigned char>(*at_) >= 0x20 &&
               static_cast<unsigned char>(*at_) < 0x80)
            ++at_;
        if (at_ == end_) return false;
        if (*at_ != '"') return rare_text(begin);
        put(begin, static_cast<std::size_t>(at_ - begin));
        ++at_;
        return true;
    }
    void put(const char* text, std::size_t size) {
        Node& made = node(JsonKind::text);
        made.text = text;
        made.size = static_cast<std::uint32_t>(size);
    }

    /// Reads a text with escapes or characters beyond ASCII through nlohmann-json.
    bool rare_text(const char* begin) {
        while (at_ != end_ && *at_ != '"') at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
        if (at_ == end_) return false;
        ++at_;
        json other = json::parse(begin - 1, at_, nullptr, false);
        if (!other.is_string()) return false;
        auto& kept =
            result_.unescaped_.emplace_back(std::make_unique<std::string>(std::move(other.get_ref<std::string&>())));
        put(kept->data(), kept->size());
        return true;
    }

    const char* at_;
    const char* end_;
    AnswerText& result_;
};

std::shared_ptr<const AnswerText> AnswerText::parsed(std::string_view text) {
    constexpr std::size_t longest = std::numeric_limits<std::uint32_t>::max();
    auto result = std::make_shared<AnswerText>();
    if (text.size() >= longest || !AnswerParser(text, *result).document()) return nullptr;
    return result;
}

std::optional<AnswerValue> AnswerValue::find(std::string_view name) const {
    if (!is_object()) return std::nullopt;
    for (const AnswerValue member : *this)
        if (member.text() == name) return member.value_of_name();
    return std::nullopt;
}

AnswerValue AnswerValue::operator[](std::string_view name) const {
    if (const auto found = find(name)) return *found;
    throw Error("The answer lacks " + std::string(name) + ".");
}

json AnswerValue::json() const {
    switch (kind()) {
        case JsonKind::boolean:
            return flag();
        case JsonKind::integer:
            return integer();
        case JsonKind::number:
            return number();
        case JsonKind::text:
            return std::string(text());
        case JsonKind::list: {
            nlohmann::json::array_t list;
            list.reserve(size());
            for (const AnswerValue element : *this) list.push_back(element.json());
            return list;
        }
        case JsonKind::object: {
            nlohmann::json::object_t object;
            for (const AnswerValue member : *this)
                object.insert_or_assign(object.end(), std::string(member.text()), member.value_of_name().json());
            return object;
        }
        default:
            return nullptr;
    }
}

}  // namespace contactd::proto

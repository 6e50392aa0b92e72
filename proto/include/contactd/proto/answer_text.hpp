// Parses the JSON of an answer for clients, once, into one flat list of values that refer to the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Lists the kinds of values of JSON. An integer is a number without fraction and exponent.
enum class JsonKind : std::uint8_t { null, boolean, integer, number, text, list, object };

class AnswerValue;

/// Holds a JSON document. Values refer to its text, which must outlive it.
class AnswerText {
   public:
    /// Returns null if `text` is not JSON: invalid syntax or UTF-8, a number beyond double, more than 256 nested
    /// levels.
    static std::shared_ptr<const AnswerText> parsed(std::string_view text);

    AnswerValue root() const;

    struct Node {
        JsonKind kind = JsonKind::null;
        std::uint32_t size = 0;  ///< bytes of a text, elements of a list, or members of an object
        std::uint32_t end = 0;   ///< the node after this one and its descendants
        union {
            bool flag;
            std::int64_t integer;
            double number = 0;
            const char* text;
        };
    };

   private:
    friend class AnswerParser;
    friend class AnswerValue;

    std::vector<Node> nodes_;  ///< a value precedes its descendants; a member is its name, a text, and its value
    std::vector<std::unique_ptr<std::string>> unescaped_;
};

/// Refers to a value of a document, which must outlive it.
class AnswerValue {
   public:
    explicit AnswerValue(const AnswerText::Node* node, const AnswerText::Node* first) : node_(node), first_(first) {}

    JsonKind kind() const { return node_->kind; }
    bool is_null() const { return kind() == JsonKind::null; }
    bool is_object() const { return kind() == JsonKind::object; }
    bool is_array() const { return kind() == JsonKind::list; }
    bool is_string() const { return kind() == JsonKind::text; }
    bool is_number() const { return kind() == JsonKind::integer || kind() == JsonKind::number; }
    bool is_number_integer() const { return kind() == JsonKind::integer; }

    bool flag() const { return node_->flag; }
    double number() const { return kind() == JsonKind::integer ? static_cast<double>(node_->integer) : node_->number; }
    std::int64_t integer() const { return node_->integer; }
    std::string_view text() const { return {node_->text, node_->size}; }
    std::size_t size() const { return node_->size; }

    /// Returns the member of an object by its name; none if it or the object does not exist.
    std::optional<AnswerValue> find(std::string_view name) const;
    bool contains(std::string_view name) const { return find(name).has_value(); }
    /// Returns the member; throws Error if there is none.
    AnswerValue operator[](std::string_view name) const;

    /// Iterates over the elements of a list, or over the names of an object's members.
    class Iterator;
    Iterator begin() const;
    Iterator end() const;
    /// Returns the value of the member with this name.
    AnswerValue value_of_name() const { return AnswerValue(node_ + 1, first_); }

    nlohmann::json json() const;

   private:
    const AnswerText::Node* node_;
    const AnswerText::Node* first_;  ///< of the document
};

class AnswerValue::Iterator {
   public:
    Iterator(const AnswerText::Node* node, const AnswerText::Node* first, bool in_object)
        : node_(node), first_(first), in_object_(in_object) {}
    AnswerValue operator*() const { return AnswerValue(node_, first_); }
    Iterator& operator++() {
        node_ = first_ + (in_object_ ? node_ + 1 : node_)->end;
        return *this;
    }
    bool operator==(const Iterator& other) const { return node_ == other.node_; }

   private:
    const AnswerText::Node* node_;
    const AnswerText::Node* first_;
    bool in_object_;
};

inline AnswerValue AnswerText::root() const {
    return AnswerValue(nodes_.data(), nodes_.data());
}
inline AnswerValue::Iterator AnswerValue::begin() const {
    return {node_ + 1, first_, is_object()};
}
inline AnswerValue::Iterator AnswerValue::end() const {
    return {first_ + node_->end, first_, is_object()};
}

}  // namespace contactd::proto

// Compiles a schema into numbers and pointers, so that checking a document allocates nothing.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/answer_text.hpp"

namespace contactd::proto {

/// Holds the rules of one schema of draft-07 without references, with the keywords that proto/schema uses.
class Rules {
   public:
    /// Throws std::logic_error for a keyword that is unknown, or has another form than in proto/schema.
    explicit Rules(const nlohmann::json& schema);
    Rules(Rules&&) noexcept;
    ~Rules();

    /// Returns whether the document conforms. Thread-safe.
    bool conform(const nlohmann::json& document) const;
    /// Also rejects an object with a repeated name.
    bool conform(const AnswerValue& document) const;

   private:
    using Part = std::unique_ptr<const Rules>;

    struct Member {
        std::string name;
        Part rules;  ///< null: anything
        bool required = false;
    };
    struct ObjectRules {
        std::vector<Member> members;               ///< by name
        std::size_t required = 0;                  ///< of the members
        std::vector<std::string> required_beside;  ///< names that are not members
        bool closed = false;                       ///< applied to everything except the members
        Part others, names;
        std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();

        const Member* find(std::string_view name, std::size_t& after) const;
    };

    void read_type(const nlohmann::json& type);
    void read_member(const std::string& name, const nlohmann::json& schema);
    void read_required(const nlohmann::json& names);
    bool read_object_keyword(const std::string& keyword, const nlohmann::json& value);
    bool read_part_keyword(const std::string& keyword, const nlohmann::json& value);
    bool read_bound(const std::string& keyword, const nlohmann::json& value);

    template <class Value>
    bool hold_for(const Value& value) const;
    template <class Value>
    bool is_choice(const Value& value) const;
    template <class Value>
    bool list_conforms(const Value& list) const;
    template <class Value>
    bool object_conforms(const Value& object) const;
    template <class Value>
    bool parts_conform(const Value& value) const;
    bool name_conforms(std::string_view name) const;
    bool text_conforms(std::string_view text) const;
    bool number_conforms(double number) const;

    unsigned kinds_ = ~0U;  ///< one bit per kind
    std::vector<nlohmann::json> choices_;
    double least_ = -std::numeric_limits<double>::infinity(), most_ = std::numeric_limits<double>::infinity();
    double above_ = -std::numeric_limits<double>::infinity(), below_ = std::numeric_limits<double>::infinity();
    std::size_t least_characters_ = 0, most_characters_ = std::numeric_limits<std::size_t>::max();
    std::unique_ptr<const std::regex> pattern_;
    std::size_t least_items_ = 0, most_items_ = std::numeric_limits<std::size_t>::max();
    Part items_, contained_, without_, if_, then_, else_;
    std::vector<Part> all_of_, any_of_, one_of_;
    ObjectRules object_;
};

}  // namespace contactd::proto

#include "explain.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "expected.hpp"
#include "shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

std::string joined(const std::string& path, const std::string& name) {
    return path.empty() ? shortened(name) : path + "." + shortened(name);
}

std::size_t characters(const std::string& text) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

class Explainer {
   public:
    explicit Explainer(const json& root) : root_(root) {}

    void visit(const json& schema, const json& value, const std::string& path) {
        if (full() || !schema.is_object()) return;
        if (!has_type(schema, value) || !is_choice(schema, value))
            return report(path, "is " + shown(value) + "; it must be " + expected(schema));
        if (value.is_number()) visit_number(schema, value, path);
        if (value.is_string()) visit_text(schema, value.get_ref<const std::string&>(), path);
        if (value.is_array()) visit_list(schema, value, path);
        if (value.is_object()) visit_object(schema, value, path);
    }

    std::vector<Violation> take() { return std::move(violations_); }

   private:
    bool full() const { return violations_.size() >= max_violations; }

    void report(const std::string& path, const std::string& description) {
        if (full() || !reported_.insert(path).second) return;
        violations_.push_back({path, description});
    }

    void visit_number(const json& schema, const json& value, const std::string& path) {
        if (const auto rule = broken_bound(schema, value.get<double>()))
            report(path, "is " + shown(value) + "; it must " + *rule);
        else if (schema.contains("not") && is_choice(schema["not"], value))
            report(path, "is " + shown(value) + "; it must not be " + shown(value));
    }

    void visit_text(const json& schema, const std::string& value, const std::string& path) {
        const std::size_t length = characters(value);
        const auto least = schema.value("minLength", std::size_t{0});
        if (length < least)
            report(path,
                   "has " + std::to_string(length) + " characters; it must have at least " + std::to_string(least));
        if (schema.contains("maxLength") && length > schema["maxLength"].get<std::size_t>())
            report(path,
                   "has " + std::to_string(length) + " characters; it must have at most " + shown(schema["maxLength"]));
    }

    void visit_list(const json& schema, const json& value, const std::string& path) {
        const auto least = schema.value("minItems", std::size_t{0});
        const auto most = schema.value("maxItems", value.size());
        if (value.size() < least || value.size() > most) {
            const std::string rule = least == most          ? std::to_string(least)
                                     : value.size() < least ? "at least " + std::to_string(least)
                                                            : "at most " + std::to_string(most);
            return report(path, "has " + std::to_string(value.size()) + " values; it must have " + rule);
        }
        const auto items = schema.find("items");
        if (items == schema.end()) return;
        for (std::size_t i = 0; i < value.size() && !full(); ++i)
            visit(*items, value[i], path + "[" + std::to_string(i) + "]");
    }

    void visit_object(const json& schema, const json& value, const std::string& path) {
        const json properties = schema.value("properties", json::object());
        for (const json& name : schema.value("required", json::array()))
            if (!value.contains(name))
                report(joined(path, name),
                       "is missing; it must be " + expected(properties.value(name, json::object())));
        visit_members(schema, properties, value, path);
        visit_size(schema, properties, value, path);
        visit_condition(schema, value, path);
        for (const json& part : schema.value("allOf", json::array())) visit(part, value, path);
    }

    void visit_members(const json& schema, const json& properties, const json& value, const std::string& path) {
        const json others = schema.value("additionalProperties", json(true));
        for (const auto& member : value.items()) {
            if (full()) return;
            const std::string field = joined(path, member.key());
            if (properties.contains(member.key()))
                visit(properties[member.key()], member.value(), field);
            else if (others == false)
                report(field, "is not a field of " + (path.empty() ? root_.value("title", "the message") : path) +
                                  "; " + known_fields(properties));
            else
                visit(others, member.value(), field);
        }
    }

    static std::string known_fields(const json& properties) {
        const std::vector<std::string> names = names_of(properties);
        return names.empty() ? "there are none" : "known fields are " + listed(names);
    }

    void visit_size(const json& schema, const json& properties, const json& value, const std::string& path) {
        const auto least = schema.value("minProperties", std::size_t{0});
        const auto most = schema.value("maxProperties", value.size());
        if (value.size() >= least && value.size() <= most) return;
        const std::string amount = least == most ? "exactly " : value.size() < least ? "at least " : "at most ";
        const std::size_t bound = value.size() < least ? least : most;
        report(path, "is " + shown(value) + "; it must hold " + amount + (bound == 1 ? "one" : std::to_string(bound)) +
                         " of " + listed(names_of(properties)));
    }

    /// if: fields that are there, constants of some; then: the names of the fields that go with them, and perhaps, as
    /// its description, why others do not.
    void visit_condition(const json& schema, const json& value, const std::string& path) {
        if (!schema.contains("if")) return;
        Explainer condition(root_);
        condition.visit(schema["if"], value, path);
        if (!condition.violations_.empty()) return visit(schema.value("else", json()), value, path);
        if (!schema.contains("then")) return;
        const json& then = schema["then"];
        visit(then, value, path);
        const json allowed = then.value("propertyNames", json::object());
        const std::string reason = then.value("description", std::string());
        for (const auto& member : value.items())
            if (!is_choice(allowed, member.key()))
                report(joined(path, member.key()), "does not go with " + conditions_of(schema["if"]) + "; only " +
                                                       listed(allowed["enum"].get<std::vector<std::string>>()) + " do" +
                                                       (reason.empty() ? "" : ": " + reason));
    }

    static std::string conditions_of(const json& condition) {
        std::string words;
        const auto add = [&](const std::string& word) { words += (words.empty() ? "" : " and ") + word; };
        const json properties = condition.value("properties", json::object());
        for (const json& name : condition.value("required", json::array()))
            if (!properties.contains(name)) add(name);
        for (const auto& property : properties.items()) add(property.key() + " " + shown(property.value()["const"]));
        return words;
    }

    const json& root_;
    std::vector<Violation> violations_;
    std::set<std::string> reported_;
};

}  // namespace

std::vector<Violation> explain(const json& schema, const json& document) {
    Explainer explainer(schema);
    explainer.visit(schema, document, "");
    return explainer.take();
}

}  // namespace contactd::proto

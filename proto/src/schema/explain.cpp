#include "explain.hpp"

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "expected.hpp"
#include "shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

std::string joined(const std::string& path, const std::string& name) {
    return path.empty() ? shortened(name) : path + "." + shortened(name);
}

const json& nothing() {
    static const json none = json::object();
    return none;
}

/// Returns a member of a schema, or an empty object.
const json& member(const json& schema, std::string_view name) {
    const auto at = schema.find(name);
    return at == schema.end() ? nothing() : *at;
}

class Explainer {
   public:
    explicit Explainer(const json& root) : root_(root) {}

    void visit(const json& schema, const json& value, const std::string& path) {
        visit(schema, member(schema, "properties"), value, path);
    }

    std::vector<Violation> take() { return std::move(violations_); }

   private:
    /// `known` describes the fields of an object: its schema's properties, also in the branches of that schema.
    void visit(const json& schema, const json& known, const json& value, const std::string& path) {
        if (full() || !schema.is_object()) return;
        if (!has_type(schema, value) || !is_choice(schema, value))
            return report(path,
                          "is " + shown(value) + "; it must be " + expected(schema) + closest_choice(schema, value));
        if (value.is_number()) visit_number(schema, value, path);
        if (value.is_string()) visit_text(schema, value.get_ref<const std::string&>(), path);
        if (value.is_array()) visit_list(schema, value, path);
        if (value.is_object()) visit_object(schema, known, value, path);
    }

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
        if (least > 0 && value.starts_with('\0')) report(path, "begins with a zero byte; it must be text");
        if (length < least)
            report(path,
                   "has " + std::to_string(length) + " characters; it must have at least " + std::to_string(least));
        if (schema.contains("maxLength") && length > schema["maxLength"].get<std::size_t>())
            report(path,
                   "has " + std::to_string(length) + " characters; it must have at most " + shown(schema["maxLength"]));
        if (breaks_pattern(schema, value)) report(path, "is " + shown(value) + "; it must be " + expected(schema));
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
        if (const json& required_item = member(schema, "contains"); !required_item.empty()) {
            if (std::none_of(value.begin(), value.end(),
                             [&](const json& entry) { return has_type(required_item, entry); }))
                return report(path, "has no value that is " + expected(required_item) + "; it must have at least one");
        }
        const json& items = member(schema, "items");
        if (items.empty()) return;
        for (std::size_t i = 0; i < value.size() && !full(); ++i)
            visit(items, value[i], path + "[" + std::to_string(i) + "]");
    }

    void visit_object(const json& schema, const json& known, const json& value, const std::string& path) {
        const json& properties = member(schema, "properties");
        for (const json& entry : member(schema, "required")) {
            const auto& name = entry.get_ref<const std::string&>();
            const json& field = member(properties.contains(name) ? properties : known, name);
            if (!value.contains(name)) report(joined(path, name), "is missing; it must be " + expected(field));
        }
        const json& names = member(schema, "propertyNames");
        for (const auto& entry : value.items())
            if (characters(entry.key()) > names.value("maxLength", entry.key().size()))
                report(path, "has a field of " + std::to_string(characters(entry.key())) +
                                 " characters; a name must have at most " + shown(names["maxLength"]));
        visit_members(schema, properties, value, path);
        visit_size(schema, properties, value, path);
        visit_alternatives(schema, known, value, path);
        visit_condition(schema, known, value, path);
        for (const json& part : member(schema, "allOf")) visit(part, known, value, path);
    }

    /// anyOf and oneOf: each branch requires one field. oneOf accepts exactly one of them, anyOf at least one.
    void visit_alternatives(const json& schema, const json& known, const json& value, const std::string& path) {
        const bool exclusive = schema.contains("oneOf");
        std::vector<std::string> there, lacking;
        for (const json& choice : member(schema, exclusive ? "oneOf" : "anyOf")) {
            const auto name = choice["required"][0].get<std::string>();
            (value.contains(name) ? there : lacking).push_back(name);
        }
        if (there.empty() && !lacking.empty()) {
            const std::vector<std::string> others(lacking.begin() + 1, lacking.end());
            report(joined(path, lacking[0]), "is missing; it must be " + expected(member(known, lacking[0])) +
                                                 ", unless " + listed(others, " or ") + " is given");
        }
        if (exclusive && there.size() > 1)
            report(joined(path, there[1]), "cannot be combined with " + there[0] + "; remove one of them");
    }

    void visit_members(const json& schema, const json& properties, const json& value, const std::string& path) {
        const auto at = schema.find("additionalProperties");
        const json& others = at == schema.end() ? nothing() : *at;
        for (const auto& entry : value.items()) {
            if (full()) return;
            const std::string field = joined(path, entry.key());
            if (properties.contains(entry.key()))
                visit(properties[entry.key()], entry.value(), field);
            else if (others == false)
                report(field, "is not a field of " + (path.empty() ? root_.value("title", "the message") : path) +
                                  closest_field(entry.key(), properties) + "; " + known_fields(properties));
            else
                visit(others, entry.value(), field);
        }
    }

    /// Returns a question that suggests a keyword of the schema, or an empty text if none is similar.
    static std::string closest_choice(const json& schema, const json& value) {
        if (!value.is_string() || !schema.contains("enum")) return "";
        std::vector<std::string> choices;
        for (const json& choice : schema["enum"])
            if (choice.is_string()) choices.push_back(choice.get<std::string>());
        const std::string closest = closest_name(value.get_ref<const std::string&>(), choices);
        return closest.empty() ? "" : ". Did you mean " + shown(json(closest)) + "?";
    }

    static std::string closest_field(const std::string& name, const json& properties) {
        const std::string closest = closest_name(name, names_of(properties));
        return closest.empty() ? "" : ", but " + closest + " is";
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
        const std::string problem = "is " + shown(value) + "; it must contain " + amount;
        const std::string number = bound == 1 ? "one" : std::to_string(bound);
        const bool open = schema.contains("additionalProperties") && schema["additionalProperties"] != false;
        report(path, problem + number + (open ? " fields" : " of " + listed(names_of(properties))));
    }

    /// `if` lists required fields and constants. `then` lists the names of the fields that can be combined with them;
    /// its description, if any, is the reason.
    void visit_condition(const json& schema, const json& known, const json& value, const std::string& path) {
        if (!schema.contains("if")) return;
        Explainer condition(root_);
        condition.visit(schema["if"], value, path);
        if (!condition.violations_.empty()) return visit(member(schema, "else"), known, value, path);
        if (!schema.contains("then")) return;
        const json& then = schema["then"];
        visit(then, known, value, path);
        const json& allowed = member(then, "propertyNames");
        const std::string reason = then.value("description", std::string());
        for (const auto& entry : value.items())
            if (!is_choice(allowed, entry.key()))
                report(joined(path, entry.key()), "cannot be combined with " + conditions_of(schema["if"]) +
                                                      ", which allows only " +
                                                      listed(allowed["enum"].get<std::vector<std::string>>()) +
                                                      (reason.empty() ? "" : ": " + reason));
    }

    static std::string conditions_of(const json& condition) {
        std::string text;
        const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
        const json properties = condition.value("properties", json::object());
        for (const json& name : condition.value("required", json::array()))
            if (!properties.contains(name)) add(name);
        for (const auto& property : properties.items())
            add(property.key() + (property.value().contains("const") ? " " + shown(property.value()["const"])
                                                                     : "." + conditions_of(property.value())));
        return text;
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

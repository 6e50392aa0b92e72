#include "contactd/field_path.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

std::string names_of(const FieldType& type) {
    std::string names;
    for (const Field& field : type.fields) names += (names.empty() ? "" : ", ") + std::string(field.name);
    return names;
}

/// Parses "springs" or "patches[2]" to name and index.
std::pair<std::string_view, std::optional<std::size_t>> parsed(std::string_view segment, const std::string& path) {
    const std::size_t bracket = segment.find('[');
    if (bracket == std::string_view::npos) return {segment, {}};
    const std::string_view inner = segment.substr(bracket + 1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(inner.data(), inner.data() + inner.size(), index);
    if (error != std::errc() || end != inner.data() + inner.size() - 1 || *end != ']')
        throw InvalidArgument(path,
                              "is not a path; write entries of lists as in patches[0].forces.track.Fz, counted from 0");
    return {segment.substr(0, bracket), index};
}

[[noreturn]] void refuse(const FieldPath& path, const std::string& problem) {
    throw InvalidArgument(path.text(), problem);
}

bool has_text(const FieldType& type) {
    return type.kind == FieldKind::keyword || type.kind == FieldKind::text;
}

}  // namespace

FieldPath::FieldPath(const FieldType& root, std::string text) : text_(std::move(text)), type_(&root) {
    std::string_view rest = text_;
    do {
        const std::size_t point = std::min(rest.find('.'), rest.size());
        const auto [name, index] = parsed(rest.substr(0, point), text_);
        rest = rest.substr(std::min(point + 1, rest.size()));
        const auto found = std::ranges::find(type_->fields, name, &Field::name);
        if (found == type_->fields.end()) {
            const std::string known = names_of(*type_);
            throw InvalidArgument(text_,
                                  "is not a field: there is no \"" + std::string(name) + "\"" +
                                      (known.empty() ? "; the part before it has no fields" : ", only " + known));
        }
        type_ = &found->type();
        if (index && type_->kind != FieldKind::list)
            throw InvalidArgument(text_, "is not a field: " + std::string(name) + " is not a list");
        if (index) type_ = &type_->element();
        steps_.push_back({&*found, index});
    } while (!rest.empty());
}

const void* FieldPath::find(const void* root) const {
    for (const auto& [field, index] : steps_) {
        root = field->find(root);
        if (root == nullptr) return nullptr;
        if (!index) continue;
        const FieldType& list = field->type();
        if (*index >= list.size(root)) return nullptr;
        root = list.at(root, *index);
    }
    return root;
}

void* FieldPath::make(void* root) const {
    for (const auto& [field, index] : steps_) {
        root = field->make(root);
        if (!index) continue;
        const FieldType& list = field->type();
        const std::size_t size = list.size(root);
        if (*index > size)
            refuse(*this, "skips entries: " + std::string(field->name) + " has " + std::to_string(size) +
                              ", and an entry can be added only after the last one");
        root = *index == size ? list.add(root) : const_cast<void*>(list.at(root, *index));
    }
    return root;
}

void FieldPath::clear(void* root) const {
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
        const auto& [field, index] = steps_[i];
        if (field->find(root) == nullptr) return;
        root = field->make(root);
        if (!index) continue;
        if (*index >= field->type().size(root)) return;
        root = const_cast<void*>(field->type().at(root, *index));
    }
    const auto& [field, index] = steps_.back();
    if (field->clear != nullptr && !index)
        field->clear(root);
    else if (!std::isnan(field->none) && !index)
        *static_cast<double*>(field->make(root)) = field->none;
    else if (type_->kind == FieldKind::list && !index)
        type_->empty(field->make(root));
    else
        refuse(*this, "is required; only optional fields and whole lists can be cleared");
}

void set_number(const FieldPath& path, void* root, double value) {
    const FieldType& type = path.type();
    const bool is_count = type.kind == FieldKind::integer || type.kind == FieldKind::flag;
    if (type.kind != FieldKind::number && !is_count)
        refuse(path, has_text(type)                   ? "expects a word, not a number"
                     : type.kind == FieldKind::list   ? "is a list; name a field of its entries, as in mu[0].angle"
                     : type.kind == FieldKind::custom ? "cannot be set by a path; use the function for it"
                                                      : "is not a number; name one of its fields");
    if (type.kind == FieldKind::flag && value != 0 && value != 1)
        refuse(path, "is " + number_text(value) + "; it must be 0 or 1");
    if (is_count && !(std::trunc(value) == value && std::abs(value) <= 1e15))
        refuse(path, "is " + number_text(value) + "; it must be a whole number");
    check_number(path.field(), value, path.text());
    void* place = path.make(root);
    if (is_count)
        type.set_integer(place, static_cast<std::int64_t>(value));
    else
        *static_cast<double*>(place) = value;
}

void set_text(const FieldPath& path, void* root, std::string_view text) {
    const FieldType& type = path.type();
    if (!has_text(type)) refuse(path, "expects a number, not a word");
    if (type.kind == FieldKind::text) {
        *static_cast<std::string*>(path.make(root)) = text;
        return;
    }
    const auto found = std::ranges::find(type.keywords, text);
    if (found == type.keywords.end()) {
        std::string keywords;
        for (const std::string_view keyword : type.keywords)
            keywords += (keywords.empty() ? "" : ", ") + std::string(keyword);
        refuse(path, "is \"" + std::string(text) + "\"; it must be one of " + keywords);
    }
    type.set_integer(path.make(root), found - type.keywords.begin());
}

std::optional<double> number_at(const FieldPath& path, const void* root) {
    const FieldType& type = path.type();
    const void* value = path.find(root);
    switch (type.kind) {
        case FieldKind::number:
            if (value == nullptr || *static_cast<const double*>(value) == path.field().none) return {};
            return *static_cast<const double*>(value);
        case FieldKind::integer:
        case FieldKind::flag:
            return value == nullptr ? std::optional<double>() : static_cast<double>(type.integer(value));
        case FieldKind::list:
            return value == nullptr ? std::optional<double>() : static_cast<double>(type.size(value));
        default:
            refuse(path, has_text(type) ? "is a word, not a number" : "is not a number; name one of its fields");
    }
}

std::optional<std::string> text_at(const FieldPath& path, const void* root) {
    const FieldType& type = path.type();
    if (!has_text(type)) refuse(path, "is not a word");
    const void* value = path.find(root);
    if (value == nullptr) return {};
    if (type.kind == FieldKind::text) return *static_cast<const std::string*>(value);
    return std::string(type.keywords[static_cast<std::size_t>(type.integer(value))]);
}

}  // namespace contactd

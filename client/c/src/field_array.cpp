#include "field_array.hpp"

#include <cmath>
#include <string>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"

namespace contactd::c {
namespace {

bool is_number(const FieldType& type) {
    return type.kind == FieldKind::number || type.kind == FieldKind::integer || type.kind == FieldKind::flag;
}

[[noreturn]] void refuse(const FieldPath& path) {
    throw InvalidArgument(path.text(), "is not an array, because it contains fields other than numbers");
}

/// Returns the count of numbers in an object, or in an entry of a list.
std::size_t width_of(const FieldType& type, const FieldPath& path) {
    if (is_number(type)) return 1;
    if (type.kind != FieldKind::object) refuse(path);
    std::size_t width = 0;
    for (const Field& field : type.fields) width += width_of(field.type(), path);
    return width;
}

/// Returns false if an optional value is absent.
bool append(const FieldType& type, const void* value, std::vector<double>& numbers) {
    if (value == nullptr) return false;
    if (type.kind == FieldKind::number)
        numbers.push_back(*static_cast<const double*>(value));
    else if (is_number(type))
        numbers.push_back(static_cast<double>(type.integer(value)));
    for (const Field& field : type.fields)
        if (!append(field.type(), field.find(value), numbers)) return false;
    return true;
}

void check(const Field& field, const FieldType& type, const std::string& name, const double*& next) {
    if (is_number(type)) {
        const double number = *next++;
        check_number(field, number, name);
        if (type.kind != FieldKind::number && std::trunc(number) != number)
            throw InvalidArgument(name, "is " + std::to_string(number) + "; it must be a whole number");
    }
    for (const Field& inner : type.fields) check(inner, inner.type(), name + "." + std::string(inner.name), next);
}

void write(const FieldType& type, void* value, const double*& next) {
    if (type.kind == FieldKind::number)
        *static_cast<double*>(value) = *next++;
    else if (is_number(type))
        type.set_integer(value, static_cast<std::int64_t>(*next++));
    for (const Field& field : type.fields) write(field.type(), field.make(value), next);
}

}  // namespace

bool is_grid_array(const FieldType& type) {
    return &type == &custom_type<std::vector<double>>() || &type == &custom_type<std::vector<ElementState>>();
}

bool is_one_or_array(const FieldType& type) {
    return &type == &custom_type<ElementwiseCoefficient>();
}

std::optional<std::vector<double>> numbers_at(const FieldPath& path, const void* root) {
    const FieldType& type = path.type();
    const void* value = path.find(root);
    if (is_grid_array(type)) {
        if (value == nullptr) return {};
        if (&type == &custom_type<std::vector<double>>()) return *static_cast<const std::vector<double>*>(value);
        const auto& division = *static_cast<const std::vector<ElementState>*>(value);
        std::vector<double> numbers;
        for (const ElementState state : division) numbers.push_back(static_cast<double>(state));
        return numbers;
    }
    const bool is_list = type.kind == FieldKind::list;
    width_of(is_list ? type.element() : type, path);
    std::vector<double> numbers;
    if (!is_list) return append(type, value, numbers) ? std::optional(numbers) : std::nullopt;
    if (value == nullptr) return {};
    for (std::size_t i = 0; i < type.size(value); ++i)
        if (!append(type.element(), type.at(value, i), numbers)) return {};
    return numbers;
}

void set_numbers(const FieldPath& path, void* root, std::span<const double> values) {
    const FieldType& type = path.type();
    if (&type == &custom_type<std::vector<double>>() || is_one_or_array(type)) {
        for (const double value : values) check_number(path.field(), value, path.text());
        static_cast<std::vector<double>*>(path.make(root))->assign(values.begin(), values.end());
        return;
    }
    const bool is_list = type.kind == FieldKind::list;
    const FieldType& entry = is_list ? type.element() : type;
    const std::size_t width = width_of(entry, path), entries = values.size() / width;
    if (values.size() % width != 0 || (!is_list && entries != 1))
        throw InvalidArgument("count", "is " + std::to_string(values.size()) + "; " + path.text() + " has " +
                                           std::to_string(width) + (is_list ? " numbers for each entry" : " numbers"));
    const double* next = values.data();
    for (std::size_t i = 0; i < entries; ++i)
        check(path.field(), entry, is_list ? path.text() + "[" + std::to_string(i) + "]" : path.text(), next);
    void* value = path.make(root);
    next = values.data();
    if (!is_list) return write(type, value, next);
    type.empty(value);
    for (std::size_t i = 0; i < entries; ++i) write(entry, type.add(value), next);
}

}  // namespace contactd::c

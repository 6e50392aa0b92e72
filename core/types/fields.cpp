#include "contactd/fields.hpp"

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

/// Returns "lie in (0, 1]", or simpler words for bounds at zero, with the unit.
std::string must(const Bounds& bounds, std::string_view unit) {
    const bool bounded = std::isfinite(bounds.most);
    const std::string most = number_text(bounds.most);
    std::string sentence;
    if (bounds.least == 0 && !bounds.most_excluded && bounds.most != 1)
        sentence = (bounds.least_excluded ? "be positive" : "be zero or positive") +
                   std::string(bounded ? " and at most " + most : "");
    else if (bounded || std::isfinite(bounds.least))
        sentence = std::string("lie in ") + (bounds.least_excluded || !std::isfinite(bounds.least) ? "(" : "[") +
                   number_text(bounds.least) + ", " + most + (bounds.most_excluded || !bounded ? ")" : "]");
    else
        sentence = "be finite";
    return unit.empty() ? sentence : sentence + " " + std::string(unit);
}

void check_field(const Field& field, const void* value) {
    const FieldType& type = field.type();
    const std::string name(field.name);
    switch (type.kind) {
        case FieldKind::number:
            return check_number(field, *static_cast<const double*>(value), name);
        case FieldKind::integer:
            return check_number(field, static_cast<double>(type.integer(value)), name);
        case FieldKind::object:
            return below(name, [&] { check_bounds(type, value); });
        case FieldKind::list:
            for (std::size_t i = 0; i < type.size(value); ++i)
                below(name + "[" + std::to_string(i) + "]", [&] { check_bounds(type.element(), type.at(value, i)); });
            return;
        default:
            return;
    }
}

}  // namespace

void check_number(const Field& field, double number, const std::string& name) {
    if (number == field.none) return;
    if (!field.bounds.contain(number))
        throw InvalidArgument(name, "is " + number_text(number) + "; it must " + must(field.bounds, field.unit));
}

void check_bounds(const FieldType& type, const void* value) {
    for (const Field& field : type.fields)
        if (const void* found = field.find(value)) check_field(field, found);
}

namespace {

/// Reverses the sign of every number, whatever its parity.
void negate(const FieldType& type, void* value) {
    if (type.kind == FieldKind::number) {
        double& number = *static_cast<double*>(value);
        number = 0 - number;  // avoids a negative zero
    }
    for (const Field& field : type.fields)
        if (field.find(value) != nullptr) negate(field.type(), field.make(value));
}

}  // namespace

void mirror_fields(const FieldType& type, void* value) {
    if (type.kind == FieldKind::list && type.element().kind != FieldKind::number)
        for (std::size_t i = 0; i < type.size(value); ++i)
            mirror_fields(type.element(), const_cast<void*>(type.at(value, i)));
    for (const Field& field : type.fields) {
        if (field.find(value) == nullptr) continue;
        void* found = field.make(value);
        mirror_fields(field.type(), found);
        if (field.parity == MirrorParity::odd) negate(field.type(), found);
    }
}

}  // namespace contactd

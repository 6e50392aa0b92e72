// Generates values with random fields within their bounds, from the lists of fields, for properties of every field.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "contactd/fields.hpp"
#include "contactd/fields/profile_spec.hpp"

namespace contactd {

/// Calls `visit` with each number below the fields of a value, and with its path, such as "track.springs.y".
inline void visit_numbers(const FieldType& type, void* value, const std::string& path,
                          const std::function<void(const Field&, double&, const std::string&)>& visit) {
    for (const Field& field : type.fields) {
        if (field.find(value) == nullptr) continue;
        void* found = field.make(value);
        const FieldType& inner = field.type();
        const std::string name = (path.empty() ? "" : path + ".") + std::string(field.name);
        if (inner.kind == FieldKind::number) visit(field, *static_cast<double*>(found), name);
        visit_numbers(inner, found, name, visit);
    }
}

/// Sets every field except those of custom types and lists; optional ones are present.
inline void fill_fields(const FieldType& type, void* value, std::mt19937& random) {
    for (const Field& field : type.fields) {
        const FieldType& inner = field.type();
        if (inner.kind == FieldKind::custom || inner.kind == FieldKind::list) continue;
        void* found = field.make(value);
        const double least = std::max(field.bounds.least, -1e6), most = std::min(field.bounds.most, 1e6);
        if (inner.kind == FieldKind::number)
            *static_cast<double*>(found) = std::uniform_real_distribution(std::nextafter(least, most), most)(random);
        if (inner.kind == FieldKind::integer)
            inner.set_integer(found,
                              std::uniform_int_distribution(static_cast<int>(least), static_cast<int>(most))(random));
        if (inner.kind == FieldKind::flag) inner.set_integer(found, static_cast<int>(random() % 2));
        if (inner.kind == FieldKind::keyword)
            inner.set_integer(found, static_cast<int>(random() % inner.keywords.size()));
        if (inner.kind == FieldKind::text) *static_cast<std::string*>(found) = std::to_string(random());
        // All other shapes contain points, which have a custom type, or ordered ends.
        if (&inner == &type_of<ProfileSpec>())
            fill_fields(type_of<Rail60E1>(), &static_cast<ProfileSpec*>(found)->shape.emplace<Rail60E1>(), random);
        else
            fill_fields(inner, found, random);
    }
}

template <class T>
T with_random_fields(unsigned seed) {
    std::mt19937 random(seed);
    T value;
    fill_fields(type_of<T>(), &value, random);
    return value;
}

}  // namespace contactd

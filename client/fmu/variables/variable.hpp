// Describes the variables of an FMU: one list for each kind, which the model, both versions of FMI, the model
// descriptions and the page docs/fmu.md read.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace contactd::fmu {

enum class Type { real, integer, boolean, enumeration, text };

/// parameter: set before the simulation, and fixed in it. tunable: a parameter that may change between steps.
enum class Role { time, parameter, tunable, input, output };

/// Words; the first one is 0. The order is that of contactd.h if it has them.
struct Enumeration {
    std::string_view name;
    std::span<const std::string_view> keywords;
    std::string_view overrides{};  ///< what the integer for its variable says
};

/// A variable's value reference is its index in its list.
struct Variable {
    std::string_view name;
    Role role = Role::parameter;
    Type type = Type::real;
    std::string_view unit{};                   ///< unit of a real: one of `units`, or none
    double start = 0;                          ///< except texts, which are initially empty or `text`
    std::string_view text{};                   ///< what a text starts with
    const Enumeration* enumeration = nullptr;  ///< for enumerations, integers that represent them, and keyword_at
    std::string_view same_as{};                ///< for an integer instead of an enumeration: the enumeration's name
    std::string_view says{};                   ///< a sentence or two
    std::string_view path{};                   ///< path of a field that contactd.h sets or reads; words are keywords
    bool zero_is_absent = false;               ///< true for an optional field, which is omitted if the value is 0
};

/// Describes a unit in the base units of SI: kg^kg m^m s^s rad^rad K^K, times the factor, plus the offset.
struct Unit {
    std::string_view name;
    double factor;
    int kg, m, s, rad;
    int K = 0;
    double offset = 0;
};

/// Uses N and mm, as everywhere in contactd; importers convert by the factors.
inline constexpr Unit units[] = {
    {"mm", 1e-3, 0, 1, 0, 0},
    {"mm2", 1e-6, 0, 2, 0, 0},
    {"rad", 1, 0, 0, 0, 1},
    {"rad/mm", 1e3, 0, -1, 0, 1},
    {"s", 1, 0, 0, 1, 0},
    {"mm/s", 1e-3, 0, 1, -1, 0},
    {"rad/s", 1, 0, 0, -1, 1},
    {"N", 1, 1, 1, -2, 0},
    {"N.mm", 1e-3, 1, 2, -2, 0},
    {"N.mm/s", 1e-3, 1, 2, -3, 0},
    {"N/mm2", 1e6, 1, -1, -2, 0},
    {"N/mm", 1e3, 1, 0, -2, 0},
    {"mm3/N", 1e-9, -1, 2, 2, 0},
    {"N/mm3", 1e9, 1, -2, -2, 0},
    {"K", 1, 0, 0, 0, 0, 1},
    {"degC", 1, 0, 0, 0, 0, 1, 273.15},
    {"W/(m.K)", 1, 1, 1, -3, 0, -1},
    {"J/(kg.K)", 1, 0, 2, -2, 0, -1},
    {"kg/m3", 1, 1, -3, 0, 0},
};

constexpr Variable real(std::string_view name, Role role, std::string_view unit, double start, std::string_view says) {
    return {.name = name, .role = role, .unit = unit, .start = start, .says = says};
}
constexpr Variable integer(std::string_view name, Role role, int start, std::string_view says) {
    return {.name = name, .role = role, .type = Type::integer, .start = double(start), .says = says};
}
constexpr Variable boolean(std::string_view name, Role role, bool start, std::string_view says) {
    return {.name = name, .role = role, .type = Type::boolean, .start = double(start), .says = says};
}
constexpr Variable text(std::string_view name, std::string_view start, std::string_view says) {
    return {.name = name, .type = Type::text, .text = start, .says = says};
}
constexpr Variable keyword(std::string_view name, const Enumeration& of, int start, std::string_view says) {
    return {.name = name, .type = Type::enumeration, .start = double(start), .enumeration = &of, .says = says};
}

/// Describes a variable that is a field of contactd.h.
constexpr Variable at_path(std::string_view path, Variable variable) {
    variable.path = path;
    return variable;
}
/// Describes an optional number, which is omitted if it is 0.
constexpr Variable absent_at_zero(std::string_view path, Variable variable) {
    variable.zero_is_absent = true;
    return at_path(path, variable);
}
/// Describes a boolean that represents one of two keywords.
constexpr Variable keyword_at(std::string_view path, const Enumeration& keywords, Variable variable) {
    variable.enumeration = &keywords;
    return at_path(path, variable);
}

/// Leaves the choice of an integer to its enumeration.
inline constexpr int as_the_enumeration = -1;

/// Describes an integer for the enumeration `as`, for importers without enumerations.
constexpr Variable number(std::string_view name, std::string_view as, const Enumeration& of, std::string_view says) {
    return {.name = name,
            .type = Type::integer,
            .start = as_the_enumeration,
            .enumeration = &of,
            .same_as = as,
            .says = says};
}
constexpr Variable number(std::string_view name, std::string_view as, const Enumeration& of) {
    return number(name, as, of, of.overrides);
}

/// Returns the keyword for a value of such a variable.
constexpr std::string_view keyword_of(const Variable& variable, double value) {
    return variable.enumeration->keywords[static_cast<std::size_t>(value)];
}

/// Returns the value reference of a name. Throws for an unknown name.
constexpr std::size_t reference_in(std::span<const Variable> list, std::string_view name) {
    for (std::size_t at = 0; at < list.size(); ++at)
        if (list[at].name == name) return at;
    throw "the list has no variable of this name";
}

/// Returns it at compile time; an unknown name is a compile error.
consteval std::size_t reference_of(std::span<const Variable> list, std::string_view name) {
    return reference_in(list, name);
}

}  // namespace contactd::fmu

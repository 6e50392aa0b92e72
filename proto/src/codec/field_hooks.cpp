// Types whose form on the wire is another one than that of their fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "codec_parts.hpp"
#include "codec_profile.hpp"
#include "contactd/body.hpp"
#include "contactd/fields/grid.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "field_codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

template <class T>
const T& as(const void* value) {
    return *static_cast<const T*>(value);
}

template <class T>
T& as(void* value) {
    return *static_cast<T*>(value);
}

// --- profiles --------------------------------------------------------------------------------------------------------
json write_profile(const void* value, const MemberPath&, ArrayWriter* arrays) {
    return encode_profile(as<ProfileSpec>(value), *arrays);
}

/// Which of both bodies a profile is of is where it stands.
void read_profile(const json& source, void* value, const MemberPath& path, const Frames& frames) {
    auto& profile = as<ProfileSpec>(value);
    profile = decode_profile(source, profile.kind, frames, path.text());
}

/// One frame may be the points of many slices, each of which has its own: they are counted as they are read.
template <class Slice>
void read_slices(const json& source, void* value, const MemberPath& path, const Frames& frames) {
    constexpr std::size_t most_points_of_slices = 10 * most_profile_points;
    auto& slices = as<std::vector<Slice>>(value);
    slices.clear();
    std::size_t points = 0;
    for (const json& slice : source) {
        const MemberPath place(path, slices.size());
        read_fields(slice, slices.emplace_back(), place, frames);
        if (const auto* given = std::get_if<ProfilePoints>(&slices.back().profile.shape))
            points += given->points.size();
        if (points > most_points_of_slices)
            throw invalid_field(
                path.text(),
                "have more than " + std::to_string(most_points_of_slices) + " points together; leave some of them out",
                reason::limit_exceeded);
    }
}

template <class Slice>
json write_slices(const void* value, const MemberPath& path, ArrayWriter* arrays) {
    json result = json::array();
    for (const Slice& slice : as<std::vector<Slice>>(value))
        result.push_back(write_fields(slice, MemberPath(path, result.size()), arrays));
    return result;
}

// --- bodies of wheels on rails: materials of half-spaces
// ---------------------------------------------------------------
json write_body(const Body& body, const std::string& field) {
    if (body.material.is_rigid()) return {{"rigid", true}};
    if (const Ics* ics = body.computed(); ics == nullptr || *ics != Ics{})
        throw InvalidArgument(field + ".ics",
                              "is no half-space in closed form; the daemon knows wheels and rails as such only");
    return encode_material(body.material);
}

json write_bodies(const void* value, const MemberPath& path, ArrayWriter*) {
    const auto& bodies = as<Bodies>(value);
    const std::string field = path.text();
    if (bodies.pair)
        throw InvalidArgument(
            field + ".pair",
            "holds coefficients of a grid, and the grids of wheels on rails are found; give materials");
    return object(
        {{"upper", write_body(bodies.upper, field + ".upper")}, {"lower", write_body(bodies.lower, field + ".lower")}});
}

Body read_body(const json& source) {
    return {source.contains("rigid") ? Material::rigid() : decode_material(source)};
}

void read_bodies(const json& source, void* value, const MemberPath&, const Frames&) {
    auto& bodies = as<Bodies>(value);
    bodies.upper = read_body(source["upper"]);
    bodies.lower = source.contains("lower") ? read_body(source["lower"]) : bodies.upper;
}

// --- one coefficient of friction is a number
// ---------------------------------------------------------------------------
using Coefficients = std::vector<FrictionAtAngle>;

json write_coefficients(const void* value, const MemberPath& path, ArrayWriter* arrays) {
    const auto& coefficients = as<Coefficients>(value);
    if (coefficients.size() == 1 && coefficients[0].angle == 0)
        return finite_field(coefficients[0].mu, path.text().c_str());
    json result = json::array();
    for (const FrictionAtAngle& entry : coefficients)
        result.push_back(write_fields(entry, MemberPath(path, result.size()), arrays));
    return result;
}

void read_coefficients(const json& source, void* value, const MemberPath& path, const Frames& frames) {
    auto& coefficients = as<Coefficients>(value);
    coefficients.clear();
    if (source.is_number()) {
        coefficients.push_back({0, source.get<double>()});
        return;
    }
    for (const json& entry : source)
        read_fields(entry, coefficients.emplace_back(), MemberPath(path, coefficients.size() - 1), frames);
}

// --- where wheel and rail are in contact
// -------------------------------------------------------------------------------
json write_extent(const void* value, const MemberPath& path, ArrayWriter*) {
    const auto& [from, to] = as<Extent>(value);
    const std::string field = path.text();
    return {finite_field(from, field.c_str()), finite_field(to, field.c_str())};
}

void read_extent(const json& source, void* value, const MemberPath&, const Frames&) {
    as<Extent>(value) = {source[0].get<double>(), source[1].get<double>()};
}

/// The radius of what is straight is infinite, and left out.
json write_radii(const void* value, const MemberPath& path, ArrayWriter*) {
    json result = json::object();
    for (const Field& field : type_of<ContactRadii>().fields)
        if (const double radius = as<double>(field.find(value)); !std::isinf(radius))
            result[std::string(field.name)] = write_fields(radius, MemberPath(path, field.name));
    return result;
}

void read_radii(const json& source, void* value, const MemberPath& path, const Frames&) {
    constexpr double straight = std::numeric_limits<double>::infinity();
    for (const Field& field : type_of<ContactRadii>().fields) {
        auto& radius = as<double>(field.make(value));
        radius = straight;
        if (source.contains(field.name))
            read_fields(source[std::string(field.name)], radius, MemberPath(path, field.name));
    }
}

json write_grid(const void* value, const MemberPath&, ArrayWriter*) {
    return encode_grid(as<Grid>(value));
}

void read_grid(const json& source, void* value, const MemberPath&, const Frames&) {
    as<Grid>(value) = decode_grid(source);
}

// --- derivatives of contacts
// -------------------------------------------------------------------------------------------
json write_derivatives(const void* value, const MemberPath&, ArrayWriter*) {
    return encode_derivatives(as<Derivatives>(value));
}

void read_derivatives(const json& source, void* value, const MemberPath&, const Frames&) {
    as<Derivatives>(value) = decode_derivatives(source);
}

}  // namespace

const FieldHook* hook_of(const FieldType& type) {
    static const std::array hooks{
        FieldHook{&custom_type<std::vector<double>>(), nullptr, nullptr},
        FieldHook{&custom_type<std::vector<ElementState>>(), nullptr, nullptr},
        FieldHook{&custom_type<Motion>(), nullptr, nullptr},
        FieldHook{&type_of<std::vector<WheelRailPatch>>(), nullptr, nullptr},
        FieldHook{&custom_type<Derivatives>(), write_derivatives, read_derivatives},
        FieldHook{&custom_type<Extent>(), write_extent, read_extent},
        FieldHook{&type_of<ContactRadii>(), write_radii, read_radii},
        FieldHook{&type_of<Grid>(), write_grid, read_grid},
        FieldHook{&custom_type<ProfileSpec>(), write_profile, read_profile},
        FieldHook{&type_of<std::vector<RailSlice>>(), write_slices<RailSlice>, read_slices<RailSlice>},
        FieldHook{&type_of<std::vector<WheelSlice>>(), write_slices<WheelSlice>, read_slices<WheelSlice>},
        FieldHook{&custom_type<Bodies>(), write_bodies, read_bodies},
        FieldHook{&type_of<Coefficients>(), write_coefficients, read_coefficients},
    };
    if (type.kind < FieldKind::object) return nullptr;
    const auto found = std::ranges::find(hooks, &type, &FieldHook::type);
    return found == hooks.end() ? nullptr : &*found;
}

}  // namespace contactd::proto

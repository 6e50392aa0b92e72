// Converts types whose form on the wire differs from that of their fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "codec_evidence.hpp"
#include "codec_parts.hpp"
#include "codec_profile.hpp"
#include "codec_section.hpp"
#include "contactd/body.hpp"
#include "contactd/fields/grid.hpp"
#include "contactd/fields/ic_table.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

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
json write_profile(const void* value, const MemberPath&, const Writing& with) {
    return encode_profile(as<ProfileSpec>(value), *with.arrays);
}

void read_profile(const json& source, void* value, const MemberPath& path, const Reading& with) {
    decode_profile(source, as<ProfileSpec>(value), with.frames, path.text());
}

/// One frame can provide the points of many slices, each with its own copy, so points are counted while they are read.
template <class Slice>
void read_slices(const json& source, void* value, const MemberPath& path, const Reading& with) {
    auto& slices = as<std::vector<Slice>>(value);
    slices.clear();
    std::size_t points = 0;
    for (const json& slice : source) {
        const MemberPath place(path, slices.size());
        read_fields(slice, slices.emplace_back(), place, with);
        if (const auto* given = std::get_if<ProfilePoints>(&slices.back().profile.shape))
            points += given->points.size();
        if (points > most_points_of_slices)
            throw invalid_field(
                path.text(),
                "have more than " + std::to_string(most_points_of_slices) + " points together; omit some of them",
                reason::limit_exceeded);
    }
}

template <class Slice>
json write_slices(const void* value, const MemberPath& path, const Writing& with) {
    json result = json::array();
    for (const Slice& slice : as<std::vector<Slice>>(value))
        result.push_back(write_fields(slice, MemberPath(path, result.size()), with));
    return result;
}

// --- bodies of wheels on rails: materials of half-spaces
// ---------------------------------------------------------------
json write_body(const Body& body, const std::string& field) {
    if (body.material.is_rigid()) return {{"rigid", true}};
    if (const Ics* ics = body.computed(); ics == nullptr || *ics != Ics{})
        throw InvalidArgument(field + ".ics",
                              "is not a half-space in closed form, the only body that wheel-rail contact supports");
    if (body.viscoelastic)
        throw InvalidArgument(field + ".viscoelastic",
                              "is given, but wheel-rail contact supports elastic bodies only: remove it");
    return encode_material(body.material);
}

json write_bodies(const void* value, const MemberPath& path, const Writing&) {
    const auto& bodies = as<Bodies>(value);
    const std::string field = path.text();
    if (bodies.pair)
        throw InvalidArgument(
            field + ".pair",
            "contains coefficients of a grid, but wheel-rail contact determines its own grids; give materials");
    return object(
        {{"upper", write_body(bodies.upper, field + ".upper")}, {"lower", write_body(bodies.lower, field + ".lower")}});
}

Body read_body(const json& source) {
    return {source.contains("rigid") ? Material::rigid() : decode_material(source)};
}

void read_bodies(const json& source, void* value, const MemberPath&, const Reading&) {
    auto& bodies = as<Bodies>(value);
    bodies.upper = read_body(source["upper"]);
    bodies.lower = source.contains("lower") ? read_body(source["lower"]) : bodies.upper;
}

// --- one coefficient of friction is a number
// ---------------------------------------------------------------------------
using Coefficients = std::vector<FrictionAtAngle>;

json write_coefficients(const void* value, const MemberPath& path, const Writing& with) {
    const auto& coefficients = as<Coefficients>(value);
    if (coefficients.size() == 1 && coefficients[0].angle == 0)
        return finite_field(coefficients[0].mu, path.text().c_str());
    json result = json::array();
    for (const FrictionAtAngle& entry : coefficients)
        result.push_back(write_fields(entry, MemberPath(path, result.size()), with));
    return result;
}

void read_coefficients(const json& source, void* value, const MemberPath& path, const Reading& with) {
    auto& coefficients = as<Coefficients>(value);
    coefficients.clear();
    if (source.is_number()) {
        coefficients.push_back({0, source.get<double>()});
        return;
    }
    for (const json& entry : source)
        read_fields(entry, coefficients.emplace_back(), MemberPath(path, coefficients.size() - 1), with);
}

// --- where wheel and rail are in contact
// -------------------------------------------------------------------------------
json write_grid(const void* value, const MemberPath&, const Writing&) {
    return encode_grid(as<Grid>(value));
}

void read_grid(const json& source, void* value, const MemberPath&, const Reading&) {
    as<Grid>(value) = decode_grid(source);
}

// --- arrays over the grid --------------------------------------------------------------------------------------------
json over_grid(const std::vector<double>& values, const Writing& with) {
    return with.arrays->write(std::span<const double>(values), shape_of(*with.grid));
}

json write_array(const void* value, const MemberPath&, const Writing& with) {
    const auto& values = as<std::vector<double>>(value);
    if (with.grid == nullptr || values.empty()) return json::value_t::discarded;
    return over_grid(values, with);
}

void read_grid_array(const json& source, void* value, const MemberPath& path, const Reading& with) {
    if (with.grid != nullptr)
        as<std::vector<double>>(value) = read_array(source, with.frames, shape_of(*with.grid), path.text());
}

json write_coefficient(const void* value, const MemberPath& path, const Writing& with) {
    const auto& mu = as<std::vector<double>>(value);
    return mu.size() == 1 ? json(finite_field(mu[0], path.text().c_str())) : over_grid(mu, with);
}

void read_coefficient(const json& source, void* value, const MemberPath& path, const Reading& with) {
    if (source.is_number())
        as<std::vector<double>>(value) = {source.get<double>()};
    else
        read_grid_array(source, value, path, with);
}

/// Sends a paraboloid that the wire cannot express as distances.
json write_gap(const void* value, const MemberPath& path, const Writing& with) {
    const auto& gap = as<Gap>(value);
    constexpr double largest_radius = 1e12, flat = std::numeric_limits<double>::infinity();
    const auto fits = [](double radius) { return radius == flat || std::abs(radius) <= largest_radius; };
    const auto* paraboloid = std::get_if<Paraboloid>(&gap);
    const bool is_flat = paraboloid != nullptr && paraboloid->Rx == flat && paraboloid->Ry == flat;
    if (paraboloid != nullptr && (is_flat || !fits(paraboloid->Rx) || !fits(paraboloid->Ry))) {
        const Gap distances = sampled(*paraboloid, *with.grid);
        return write_object(type_of<Gap>(), &distances, path, with);
    }
    return write_object(type_of<Gap>(), value, path, with);
}

// --- where strips lie ------------------------------------------------------------------------------------------------
json write_frames(const void* value, const MemberPath&, const Writing& with) {
    return encode_frames(as<std::vector<StripFrame>>(value), *with.arrays);
}

void read_frames(const json& source, void* value, const MemberPath& path, const Reading& with) {
    as<std::vector<StripFrame>>(value) = decode_frames(source, with.frames, with.grid->ny, path.text());
}

json write_points(const void* value, const MemberPath&, const Writing& with) {
    return encode_pairs(as<std::vector<ProfilePoint>>(value), *with.arrays);
}

void read_points(const json& source, void* value, const MemberPath& path, const Reading& with) {
    as<std::vector<ProfilePoint>>(value) = decode_pairs(source, with.frames, path.text());
}

// --- bodies ---------------------------------------------------------------------------------------------------------
json write_material(const void* value, const MemberPath&, const Writing&) {
    const auto& material = as<Material>(value);
    return material.is_rigid() ? json{{"rigid", true}} : encode_material(material);
}

void read_material(const json& source, void* value, const MemberPath&, const Reading&) {
    as<Material>(value) = source.contains("rigid") ? Material::rigid() : decode_material(source);
}

json write_section(const void* value, const MemberPath&, const Writing&) {
    return encode_section(as<Section>(value));
}

void read_section(const json& source, void* value, const MemberPath& path, const Reading& with) {
    as<Section>(value) = decode_section(source, with.frames, path.text());
}

// --- tables ----------------------------------------------------------------------------------------------------------
json write_ic_evidence(const void* value, const MemberPath& path, const Writing&) {
    return write_evidence(as<IcEvidence>(value), path);
}

}  // namespace

const FieldHook* hook_of(const FieldType& type) {
    static const std::array hooks{
        FieldHook{&custom_type<std::vector<double>>(), write_array, read_grid_array},
        FieldHook{&custom_type<ElementwiseCoefficient>(), write_coefficient, read_coefficient},
        FieldHook{&type_of<Gap>(), write_gap, nullptr},
        FieldHook{&custom_type<Material>(), write_material, read_material},
        FieldHook{&custom_type<Section>(), write_section, read_section},
        FieldHook{&type_of<std::vector<ProfilePoint>>(), write_points, read_points},
        FieldHook{&custom_type<std::vector<StripFrame>>(), write_frames, read_frames},
        FieldHook{&custom_type<std::vector<ElementState>>(), nullptr, nullptr},
        FieldHook{&custom_type<Motion>(), nullptr, nullptr},
        FieldHook{&type_of<std::vector<WheelRailPatch>>(), nullptr, nullptr},
        FieldHook{&type_of<IcEvidence>(), write_ic_evidence, nullptr},
        FieldHook{&type_of<Grid>(), write_grid, read_grid},
        FieldHook{&type_of<ProfileSpec>(), write_profile, read_profile},
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

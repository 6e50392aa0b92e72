// These are the only lists of the fields of a section. The wire, files and keys visit them.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "contactd/section.hpp"

namespace contactd {

template <class Of, class Value>
struct NamedMember {
    const char* name;
    Value Of::* member;
};

template <class Of>
inline constexpr std::tuple<> named_members{};
template <>
inline constexpr std::tuple named_members<SectionPoint>{NamedMember{"y", &SectionPoint::y},
                                                        NamedMember{"z", &SectionPoint::z}};
template <>
inline constexpr std::tuple named_members<LineTo>{NamedMember{"to", &LineTo::to}};
template <>
inline constexpr std::tuple named_members<ArcTo>{NamedMember{"to", &ArcTo::to}, NamedMember{"radius", &ArcTo::radius}};
template <>
inline constexpr std::tuple named_members<SplineTo>{NamedMember{"through", &SplineTo::through}};
template <>
inline constexpr std::tuple named_members<OutlinePart>{NamedMember{"curve", &OutlinePart::curve},
                                                       NamedMember{"clamped", &OutlinePart::clamped}};
template <>
inline constexpr std::tuple named_members<Outline>{NamedMember{"start", &Outline::start},
                                                   NamedMember{"parts", &Outline::parts}};
template <>
inline constexpr std::tuple named_members<OutlineSection>{
    NamedMember{"outside", &OutlineSection::outside}, NamedMember{"holes", &OutlineSection::holes},
    NamedMember{"carrier", &OutlineSection::carrier}, NamedMember{"part", &OutlineSection::part},
    NamedMember{"from", &OutlineSection::from}};
template <>
inline constexpr std::tuple named_members<RailSection>{NamedMember{"inclination", &RailSection::inclination},
                                                       NamedMember{"support", &RailSection::support},
                                                       NamedMember{"from", &RailSection::from}};
template <>
inline constexpr std::tuple named_members<WheelRimSection>{NamedMember{"thickness", &WheelRimSection::thickness},
                                                           NamedMember{"from", &WheelRimSection::from}};
template <>
inline constexpr std::tuple named_members<EdgeBlock>{NamedMember{"width", &EdgeBlock::width},
                                                     NamedMember{"height", &EdgeBlock::height},
                                                     NamedMember{"edge_distance", &EdgeBlock::edge_distance}};
template <>
inline constexpr std::tuple named_members<Groove>{
    NamedMember{"radius", &Groove::radius}, NamedMember{"depth", &Groove::depth}, NamedMember{"width", &Groove::width},
    NamedMember{"height", &Groove::height}};
template <>
inline constexpr std::tuple named_members<RoundEnd>{NamedMember{"radius", &RoundEnd::radius},
                                                    NamedMember{"length", &RoundEnd::length}};
template <>
inline constexpr std::tuple named_members<Disc>{NamedMember{"radius", &Disc::radius}, NamedMember{"core", &Disc::core}};
template <>
inline constexpr std::tuple named_members<PlateHole>{NamedMember{"radius", &PlateHole::radius},
                                                     NamedMember{"plate_radius", &PlateHole::plate_radius}};
template <>
inline constexpr std::tuple named_members<Slab>{NamedMember{"thickness", &Slab::thickness},
                                                NamedMember{"width", &Slab::width}};
template <>
inline constexpr std::tuple named_members<ProfileSection>{NamedMember{"profile", &ProfileSection::profile},
                                                          NamedMember{"depth", &ProfileSection::depth},
                                                          NamedMember{"from", &ProfileSection::from}};
template <>
inline constexpr std::tuple named_members<ProfileSpec>{NamedMember{"kind", &ProfileSpec::kind},
                                                       NamedMember{"shape", &ProfileSpec::shape}};
template <>
inline constexpr std::tuple named_members<Rail60E1>{NamedMember{"inclination", &Rail60E1::inclination}};
template <>
inline constexpr std::tuple named_members<ArcProfile>{
    NamedMember{"radius", &ArcProfile::radius}, NamedMember{"slope", &ArcProfile::slope},
    NamedMember{"from", &ArcProfile::from}, NamedMember{"to", &ArcProfile::to}};
template <>
inline constexpr std::tuple named_members<ConeProfile>{NamedMember{"slope", &ConeProfile::slope},
                                                       NamedMember{"from", &ConeProfile::from},
                                                       NamedMember{"to", &ConeProfile::to}};
template <>
inline constexpr std::tuple named_members<StandardProfile>{NamedMember{"name", &StandardProfile::name},
                                                           NamedMember{"inclination", &StandardProfile::inclination}};
template <>
inline constexpr std::tuple named_members<ProfilePoint>{NamedMember{"y", &ProfilePoint::y},
                                                        NamedMember{"z", &ProfilePoint::z}};
template <>
inline constexpr std::tuple named_members<ProfilePoints>{
    NamedMember{"points", &ProfilePoints::points}, NamedMember{"unit", &ProfilePoints::unit},
    NamedMember{"mirror_y", &ProfilePoints::mirror_y}, NamedMember{"mirror_z", &ProfilePoints::mirror_z},
    NamedMember{"smoothing_length", &ProfilePoints::smoothing_length}};
template <>
inline constexpr std::tuple named_members<Section>{
    NamedMember{"shape", &Section::shape}, NamedMember{"size", &Section::size}, NamedMember{"turn", &Section::turn},
    NamedMember{"free", &Section::free}};

/// Lists the names of the alternatives of a std::variant, in their order.
template <class Variant>
inline constexpr std::array<std::string_view, 0> alternative_names{};
template <>
inline constexpr auto alternative_names<decltype(OutlinePart::curve)> =
    std::to_array<std::string_view>({"line", "arc", "spline"});
template <>
inline constexpr auto alternative_names<SectionShape> =
    std::to_array<std::string_view>({"outline", "rail_60e1", "rim_s1002", "edge_block", "groove", "round_end", "disc",
                                     "plate_hole", "slab", "profile_section"});
template <>
inline constexpr auto alternative_names<ProfileShape> =
    std::to_array<std::string_view>({"s1002", "rail_60e1", "arc", "cone", "points", "file", "standard"});

/// Calls `visit` with the name and the value of each field, in their order: numbers, counts, flags, words, objects with
/// named_members, lists (std::vector) and alternatives (std::variant). `Of` may be const.
template <class Of, class Visit>
void for_each_named_member(Of& at, const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field.name, at.*field.member), ...); },
               named_members<std::remove_const_t<Of>>);
}

}  // namespace contactd

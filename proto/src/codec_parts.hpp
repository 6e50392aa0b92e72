// Pieces that several messages have in common.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/material.hpp"

namespace contactd::proto {

// The words of the wire for enumerators.
inline constexpr std::pair<IcSource, std::string_view> ic_source_words[]{{IcSource::analytic, "analytic"},
                                                                         {IcSource::fem, "fem"}};
inline constexpr std::pair<LoadShape, std::string_view> load_shape_words[]{{LoadShape::constant, "constant"}};
inline constexpr std::pair<MeshKind, std::string_view> mesh_words[]{{MeshKind::hex, "hex"}};
inline constexpr std::pair<FarBoundary, std::string_view> far_boundary_words[]{{FarBoundary::clamped, "clamped"}};
inline constexpr std::pair<Sampling, std::string_view> sampling_words[]{{Sampling::fem, "fem"},
                                                                        {Sampling::linear, "linear"}};
inline constexpr std::pair<Axis, std::string_view> axis_words[]{{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}};

template <class Words>
std::string_view word_of(const Words& words, decltype(words[0].first) value) {
    for (const auto& [known, word] : words)
        if (known == value) return word;
    throw Error("An enumerator has no word on the wire.");
}

/// `word` has passed its schema, so it is one of the words.
template <class Words>
auto value_of(const Words& words, const nlohmann::json& word) {
    for (const auto& [value, known] : words)
        if (word == known) return value;
    throw Error("The word " + word.dump() + " is unknown.");
}

/// `value`, which must be finite: JSON would silently turn anything else into null. Throws Error naming `what`.
double finite(double value, const char* what);

nlohmann::json encode_material(const Material& material);
Material decode_material(const nlohmann::json& json);

/// What a request says about its coefficients.
struct Ics {
    IcSource source = IcSource::analytic;
    LoadShape load_shape = LoadShape::constant;
    FemSpec fem;  ///< the default when source is analytic
};
nlohmann::json encode_ics(const Ics& ics);
Ics decode_ics(const nlohmann::json& json);

}  // namespace contactd::proto

// Pieces that several messages have in common.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/material.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {

/// The enumerator that `word` names. It has passed its schema, so there is one.
template <class Enum>
void read_name(const nlohmann::json& word, Enum& value) {
    if (!from_name(word.get<std::string>(), value)) throw Error("The word " + word.dump() + " is unknown.");
}

/// `value`, which must be finite: JSON would silently turn anything else into null. Throws Error naming `what`.
double finite(double value, const char* what);

nlohmann::json encode_material(const Material& material);
Material decode_material(const nlohmann::json& json);

nlohmann::json encode_ics(const Ics& ics);
/// Applies preset and defaults.
Ics decode_ics(const nlohmann::json& json);

/// The fields of a mesh and its solver.
nlohmann::json encode_fem(const FemSpec& fem);
/// The fields that are there; the others stay as they are.
void decode_fem(const nlohmann::json& json, FemSpec& fem);

/// Coefficients that the request itself holds, which cover `grid`. Throws StatusError (ARRAY_INVALID).
nlohmann::json encode_given_ics(const GivenIcs& ics, ArrayWriter& arrays);
GivenIcs decode_given_ics(const nlohmann::json& json, const std::vector<std::string>& frames, const Grid& grid);

nlohmann::json encode_use(const IcUse& use);

}  // namespace contactd::proto

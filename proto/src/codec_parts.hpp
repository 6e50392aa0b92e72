// Pieces that several messages have in common.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/material.hpp"

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

/// What a request says about its coefficients.
struct Ics {
    IcSource source = IcSource::analytic;
    LoadShape load_shape = LoadShape::constant;
    FemSpec fem;  ///< the default when source is analytic
};
nlohmann::json encode_ics(const Ics& ics);
Ics decode_ics(const nlohmann::json& json);

}  // namespace contactd::proto

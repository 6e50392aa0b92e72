// Encodes and decodes parts that several messages share.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/material.hpp"
#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/grid.hpp"

namespace contactd::proto {

/// Returns the enumerator of `keyword`, which has passed its schema and is therefore known.
template <class Enum>
void read_name(const nlohmann::json& keyword, Enum& value) {
    if (!from_name(keyword.get<std::string>(), value)) throw Error("The word " + keyword.dump() + " is unknown.");
}

/// Returns the shape [ny, nx] of arrays over a grid.
inline std::vector<std::size_t> shape_of(const Grid& grid) {
    return {static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(grid.nx)};
}

/// Returns `value`. Throws Error naming `what` if it is not finite, because JSON would silently turn it into null.
double finite(double value, const char* what);
/// Returns `value` of a field of a request. Throws InvalidArgument naming the field if it is not finite.
double finite_field(double value, const char* field);

/// Returns nx or ny of a grid. Throws StatusError if a grid cannot have so many elements.
int decode_count(const nlohmann::json& grid, const char* name);

/// Returns the claimed shape of an array that has passed its schema. For a nested list the first entry at each depth
/// counts, down to `most_axes`.
std::vector<std::size_t> claimed_shape(const nlohmann::json& array, std::size_t most_axes);

nlohmann::json encode_material(const Material& material);
Material decode_material(const nlohmann::json& json);

nlohmann::json encode_ics(const Ics& ics);
/// Applies preset and defaults.
Ics decode_ics(const nlohmann::json& json);

/// Encodes strips of a longitudinally uniform body as an array [strips, 3]: y, z (mm), angle (rad). `field` is its
/// path.
nlohmann::json encode_frames(const std::vector<StripFrame>& frames, ArrayWriter& arrays);
std::vector<StripFrame> decode_frames(const nlohmann::json& source, const Frames& frames, int strips,
                                      const std::string& field);

/// Encodes the fields of a mesh and its solver.
nlohmann::json encode_fem(const FemSpec& fem);
/// Reads the fields that are present; the others keep their values.
void decode_fem(const nlohmann::json& json, FemSpec& fem);

/// Decodes coefficients contained in the request, which cover `grid`. Throws StatusError (ARRAY_INVALID). `field` is
/// their path.
nlohmann::json encode_given_ics(const GivenIcs& ics, ArrayWriter& arrays);
GivenIcs decode_given_ics(const nlohmann::json& json, const Frames& frames, const Grid& grid, const std::string& field);

/// Encodes and decodes `bodies` and `ics` of a request.
void encode_bodies(const ContactSetup& setup, nlohmann::json& params, ArrayWriter& arrays);
void decode_bodies(const nlohmann::json& params, const Frames& frames, ContactSetup& setup);

/// Encodes and decodes a problem that may lack gap and load.
nlohmann::json encode_opening(const ContactProblem& problem, ArrayWriter& arrays);
ContactProblem decode_opening(const nlohmann::json& params, const Frames& frames);

/// Encodes the fields of a solution except its arrays. Throws Error for numbers that are not finite.
nlohmann::json encode_summary(const ContactSolution& solution, const Grid& grid);
/// Appends the same as text to the object at the end of `text`, which stays open.
void append_summary(std::string& text, const ContactSolution& solution, const Grid& grid);
void decode_summary(const nlohmann::json& result, ContactSolution& solution);
void decode_summary(const AnswerValue& result, ContactSolution& solution);
/// Adds those of `fields` that the solution has.
void encode_arrays(const ContactSolution& solution, const SolutionFields& fields, const Grid& grid, ArrayWriter& arrays,
                   nlohmann::json& result);
void append_arrays(std::string& text, const ContactSolution& solution, const SolutionFields& fields, const Grid& grid,
                   ArrayWriter& arrays);
/// Reads the arrays that are present. An empty `shape` takes that of the first array. Throws StatusError
/// (ARRAY_INVALID).
void decode_arrays(const nlohmann::json& result, const Frames& frames, std::vector<std::size_t> shape,
                   ContactSolution& solution);
void decode_arrays(const AnswerValue& result, const Frames& frames, std::vector<std::size_t> shape,
                   ContactSolution& solution);

/// Encodes and decodes the motion of a result.
nlohmann::json encode_motion(const Motion& motion);
Motion decode_motion(const nlohmann::json& json);

}  // namespace contactd::proto

// Describes parts of a table of influence coefficients, in which large tables are requested.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/ic_reply.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

/// Selects rows, and components by the numbers 3 * displacement axis + load axis.
struct IcPart {
    int first_row = 0;
    int rows = 0;
    std::vector<int> components;  ///< empty: all, as [3, 3, rows, nx]
    bool is_whole = true;         ///< not specified
};

/// Reads `rows` and `components` of ic.get. Throws StatusError naming the field for missing rows.
IcPart decode_ic_part(const nlohmann::json& params, int ny);
/// Encodes `rows` and `components` of a request.
nlohmann::json encode_ic_part(const IcPart& part);

/// Throws StatusError (ANSWER_TOO_LARGE), which describes how to request parts, if the part of a table of `nx` columns
/// exceeds a frame or a message.
void check_size(const IcPart& part, int nx, const MessageLimits& limits);

/// Returns the result of ic.get: the whole table, or the part [components, rows, nx] or [3, 3, rows, nx].
nlohmann::json encode_ic_part_reply(IcReply reply, const IcPart& part, ArrayWriter& arrays);

/// Copies the part of a table in `result` to `whole`, whose table has its full size. Throws StatusError if it is not
/// `part`, or belongs to another table than earlier parts.
void read_part(const nlohmann::json& result, const Frames& frames, const IcPart& part, IcReply& whole);

/// Returns the largest parts of a table of ny rows of nx that fit `limits`.
std::vector<IcPart> parts_within(const MessageLimits& limits, int nx, int ny);

}  // namespace contactd::proto

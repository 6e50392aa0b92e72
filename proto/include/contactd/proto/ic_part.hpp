// Parts of a table of influence coefficients: a large one is fetched in pieces.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/ic_reply.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

/// Rows, and the components by the numbers 3 * displacement axis + load axis.
struct IcPart {
    int first_row = 0;
    int rows = 0;
    std::vector<int> components;  ///< empty: all, as [3, 3, rows, nx]
    bool is_whole = true;         ///< nothing was named
};

/// Reads `rows` and `components` of ic.get. Throws StatusError naming the field for rows that the table does not have.
IcPart decode_ic_part(const nlohmann::json& params, int ny);
/// `rows` and `components` of a request.
nlohmann::json encode_ic_part(const IcPart& part);

/// Throws StatusError (ANSWER_TOO_LARGE), saying how to ask in pieces, when the part of a table of `nx` columns does
/// not fit one frame or message.
void check_size(const IcPart& part, int nx, const MessageLimits& limits);

/// The result of ic.get: the whole table, or [components, rows, nx] or [3, 3, rows, nx] of it.
nlohmann::json encode_ic_part_reply(IcReply reply, const IcPart& part, ArrayWriter& arrays);

/// Puts the part of a table that `result` holds into `whole`, whose table has its full size. Throws StatusError when it
/// is another part than `part`, or of another table than the ones before.
void read_part(const nlohmann::json& result, const Frames& frames, const IcPart& part, IcReply& whole);

/// The parts of a table of ny rows of nx that fit `limits`, each as large as may be.
std::vector<IcPart> parts_within(const MessageLimits& limits, int nx, int ny);

}  // namespace contactd::proto

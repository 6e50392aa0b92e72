// The text of the CONTACT program: refused with the line named, or read; and what was read can be written and read.
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/ic_exchange.hpp"
#include "input.hpp"

using namespace contactd;

namespace {

/// Far from the ends of what a double holds, where products of values and moduli overflow.
bool is_moderate(const GivenIcs& ics) {
    const auto moderate = [](double value) {
        return value == 0 || (std::abs(value) > 1e-50 && std::abs(value) < 1e50);
    };
    bool all = moderate(ics.dx) && moderate(ics.dy);
    for (const double value : ics.table.values) all = all && moderate(value);
    return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // With an odd first byte the caller gives the modulus.
    const bool modulus_given = size > 0 && data[0] % 2 == 1;
    const std::string_view text = fuzz::bytes_of(data, size).substr(size > 0 ? 1 : 0);
    try {
        const GivenIcs ics = from_contact_text(text, modulus_given ? std::optional(82000.0) : std::nullopt);
        if (!is_moderate(ics)) return 0;
        const GivenIcs again = from_contact_text(to_contact_text(ics, 1.0), std::nullopt);
        fuzz::require(again.table.nx == ics.table.nx && again.table.ny == ics.table.ny, "the extent stays");
        fuzz::require(again.table.values == ics.table.values, "coefficients are written with all their digits");
    } catch (const InvalidArgument& error) {
        fuzz::require(!error.field().empty(), "what cannot be read is named");
    }
    return 0;
}

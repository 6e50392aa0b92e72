// Files of profiles, and the curves that are made of them. The first byte says which format follows.
#include <array>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/read_profile.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::array names{"a.prw", "a.prr", "a.whl", "a.ban", "a.txt"};
    if (size == 0) return 0;
    const std::string name = names[data[0] % names.size()];
    const auto kind = name == "a.txt" ? std::optional(contactd::ProfileKind::rail) : std::nullopt;
    try {
        auto spec = contactd::read_profile(fuzz::bytes_of(data + 1, size - 1), name, kind);
        std::get<contactd::ProfilePoints>(spec.shape).smoothing_length = data[0] >= names.size() ? 3 : 0;
        const auto curve = contactd::make_profile(spec).curve;
        const double middle = curve.arc_length(curve.end()) / 2;
        const auto at = curve.at(curve.s_at_y(curve.at(curve.s_at_arc_length(middle)).y));
        fuzz::require(std::isfinite(at.y) && std::isfinite(at.z), "a profile's curve is finite");
    } catch (const contactd::InvalidArgument& refusal) {
        for (const char c : std::string(refusal.what())) fuzz::require(c >= ' ' && c <= '~', "refusals can be printed");
    }
    return 0;
}

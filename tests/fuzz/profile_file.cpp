// Fuzzes files of profiles, and the resulting curves. The first byte selects the format and the kind of reading.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/read_profile.hpp"
#include "input.hpp"

namespace {

using namespace contactd;

/// Reads the profile of a text: its points from 0 on, smoothed from 5 on, the text itself from 10 on, with additional
/// options.
ProfileSpec profile_of(std::uint8_t how, const std::string& name, std::string_view text) {
    const ProfileKind kind = name == "a.prw" || name == "a.whl" ? ProfileKind::wheel : ProfileKind::rail;
    if (how < 10) {
        ProfileSpec read = read_profile(text, name, kind);
        std::get<ProfilePoints>(read.shape).smoothing_length = how >= 5 ? 3 : 0;
        return read;
    }
    ProfileFile file{.name = name, .text = std::string(text)};
    if (how & 16) file.unit = 1;
    if (how & 32) file.mirror_z = (how & 64) != 0;
    if (how & 128) file.smoothing_order = 3;
    (how & 128 || how & 64 ? file.smoothing_length : file.smoothing_lambda) = 2;
    return {kind, file};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::array names{"a.prw", "a.prr", "a.whl", "a.ban", "a.txt"};
    if (size == 0) return 0;
    const std::string name = names[data[0] % names.size()];
    try {
        const auto curve = make_profile(profile_of(data[0], name, fuzz::bytes_of(data + 1, size - 1))).curve;
        const double middle = curve.arc_length(curve.end()) / 2;
        const auto at = curve.at(curve.s_at_y(curve.at(curve.s_at_arc_length(middle)).y));
        fuzz::require(std::isfinite(at.y) && std::isfinite(at.z), "a profile's curve is finite");
    } catch (const InvalidArgument& refusal) {
        for (const char c : std::string(refusal.what())) fuzz::require(c >= ' ' && c <= '~', "refusals can be printed");
    }
    return 0;
}

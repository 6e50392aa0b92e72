#include <string>

#include "../types/number_text.hpp"
#include "contactd/ic_store.hpp"
#include "sha256.hpp"

namespace contactd {
namespace {

/// Canonical JSON: members in alphabetical order, no white space, numbers by their shortest text.
std::string canonical_text(const IcSpec& spec) {
    const auto text = [](std::string_view word) { return '"' + std::string(word) + '"'; };
    std::string json = R"({"body":"half_space","dy_over_dx":)" + number_text(spec.dy);
    if (spec.source == IcSource::fem) {
        const FemSpec& fem = spec.fem;
        json += R"(,"fem":{"L_over_h":)" + number_text(fem.L_over_h) + R"(,"f":)" + number_text(fem.f) +
                R"(,"far_boundary":)" + text(name_of(fem.far_boundary)) + R"(,"h_over_hs":)" +
                number_text(fem.h_over_hs) + R"(,"l_over_h":)" + number_text(fem.l_over_h) + R"(,"mesh":)" +
                text(name_of(fem.mesh)) + R"(,"order":)" + std::to_string(fem.order) + R"(,"sampling":)" +
                text(name_of(fem.sampling)) + R"(,"strength_threshold":)" + number_text(fem.strength_threshold) +
                R"(,"tolerance":)" + number_text(fem.tolerance) + "}";
    }
    json += R"(,"load_shape":)" + text(name_of(spec.load_shape)) + R"(,"nu":)" + number_text(spec.material.nu) +
            R"(,"source":)" + text(name_of(spec.source)) + "}";
    return json;
}

}  // namespace

std::string ic_key(const IcSpec& spec) {
    const std::string text = canonical_text(dimensionless(spec));
    return sha256_hex({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace contactd

#include "layer_resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "contactd/error.hpp"
#include "influence/layered/wave_compliance.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using std::numbers::pi;

constexpr double noticed_error = 0.01;
constexpr double lost_factor = 2;  // error factor of the compliance, too large or too small
/// Another warning covers contacts with fewer elements, whose waves are too short for this estimate.
constexpr double fewest_elements = 8;
/// Elements add waves to a wave, with m more periods per element. If m exceeds twice the element size over the layer
/// thickness, only the material of the layer affects them, and their contribution is negligible.
constexpr int fewest_waves = 12, most_waves = 256;
/// If an element is at most half as wide as the first layer is thick, the material below does not affect the waves that
/// it adds. Their error is at most 0.3 %.
constexpr double fine = 0.5;

/// Computes the compliance of one body along z (mm^3/N) to a wave of wavenumber k (1/mm).
class BodyWaves {
   public:
    explicit BodyWaves(const Body& body) {
        if (const Ics* ics = body.computed(); ics != nullptr) is_bilinear_ = ics->load_shape == LoadShape::bilinear;
        if (const Layers* layers = body.layered()) {
            waves_.emplace(*layers);
            over_G_ = 1 / layers->surface().G;
            deep_ = 1 - layers->surface().nu;
        } else if (!body.material.is_rigid()) {
            over_G_ = 1 / body.material.G;
            deep_ = 1 - body.material.nu;
        }
    }

    double at(double k) const { return (waves_ ? waves_->at(k).c : deep_) * over_G_ / k; }
    double half_space(double k) const { return deep_ * over_G_ / k; }

    /// Returns the share of a wave, with k along the element, in the tractions of elements of this length.
    double share(double k, double length) const {
        const double half = k * length / 2, uniform = half == 0 ? 1 : std::sin(half) / half;
        return is_bilinear_ ? uniform * uniform : uniform;
    }

   private:
    std::optional<LayeredWaves> waves_;
    double over_G_ = 0, deep_ = 0;
    bool is_bilinear_ = false;
};

/// Wavenumbers along and across an axis, and the length of the element along it.
struct WaveAlong {
    double k, across, element;
};

/// Returns the displacements at element centres from the waves that elements add to a wave.
double added(const BodyWaves& body, const WaveAlong& along, int waves, const auto& compliance) {
    if (along.k == 0) return 0;
    double sum = 0;
    for (int m = 1; m <= waves; ++m) {
        // Takes the mean of the last two sums, because the terms alternate and fall slowly for thin layers.
        const double weight = m < waves ? 1 : 0.5;
        for (const int sign : {-1, 1}) {
            const double k = along.k + sign * 2 * pi * m / along.element;
            sum += weight * compliance(std::hypot(k, along.across)) * body.share(k, along.element);
        }
    }
    return sum;
}

double thinnest(const Bodies& bodies) {
    double result = 0;
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Layers* layers = body->layered())
            for (const Layer& layer : layers->layers)
                result = result > 0 ? std::min(result, layer.thickness) : layer.thickness;
    return result;
}

double ratio_of(const Bodies& bodies, const PatchSize& contact, double dx, double dy) {
    // A contact that extends from border to border has no wave in that direction, but only in the other one.
    const auto wavenumber = [](double length, double element) {
        return length > 0 ? 4 / std::max(length, fewest_elements * element) : 0;
    };
    const double kx = wavenumber(contact.along_x, dx), ky = wavenumber(contact.along_y, dy), k = std::hypot(kx, ky);
    if (!(k > 0)) return 1;
    const auto waves = [&](double element) {
        const double ratio = std::min(2 * element / thinnest(bodies), static_cast<double>(most_waves));
        return std::clamp(static_cast<int>(ratio), fewest_waves, most_waves);
    };
    double truth = 0, seen = 0, deep = 0, seen_deep = 0;
    for (const Body* side : {&bodies.upper, &bodies.lower}) {
        const BodyWaves body(*side);
        const double share_x = body.share(kx, dx), share_y = body.share(ky, dy);
        // Waves that are short along both axes are even smaller, and are neglected.
        const auto seen_of = [&](const auto& compliance, int along_x, int along_y) {
            return share_x * share_y * compliance(k) + share_y * added(body, {kx, ky, dx}, along_x, compliance) +
                   share_x * added(body, {ky, kx, dy}, along_y, compliance);
        };
        const auto layers = [&](double wave) { return body.at(wave); };
        const auto half_space = [&](double wave) { return body.half_space(wave); };
        truth += body.at(k);
        seen += seen_of(layers, waves(dx), waves(dy));
        deep += body.half_space(k);
        seen_deep += seen_of(half_space, fewest_waves, fewest_waves);
    }
    if (!(truth > 0)) return 1;
    // Elements carry the mean of a wave, which reduces the deflection of a half-space on any grid, but not that of a
    // foundation of springs. A ratio between this one and the one corrected for a half-space is not an error of layers.
    const double ratio = seen / truth, without_grid = ratio + (1 - seen_deep / deep);
    return ratio > 1 ? ratio : std::min(without_grid, 1.0);
}

bool are_fine(const ContactSetup& setup) {
    const double element = std::max(setup.grid.dx, setup.grid.dy);
    const auto is_fine = [&](const Body& body) {
        const Layers* layers = body.layered();
        return layers == nullptr || element <= fine * layers->layers.front().thickness;
    };
    return is_fine(setup.bodies.upper) && is_fine(setup.bodies.lower);
}

/// Returns the largest error of these elements and of elements down to half their width.
double largest_error(const Bodies& bodies, const PatchSize& contact, double dx, double dy) {
    double largest = 0;
    for (const double part : {1.0, std::numbers::sqrt2 / 2, 0.5})
        largest = std::max(largest, compliance_error(ratio_of(bodies, contact, part * dx, part * dy)));
    return largest;
}

/// Returns the size of square elements that resolve the layers to 1 % in a contact of equal length and width.
double resolving_element(const ContactSetup& setup, const PatchSize& contact) {
    const double length = std::max(contact.along_x, contact.along_y);
    double element = std::max(setup.grid.dx, setup.grid.dy);
    for (int i = 0; i < 100 && largest_error(setup.bodies, {length, length}, element, element) >= noticed_error; ++i)
        element *= 0.8;
    return element;
}

std::string advice(const ContactSetup& setup, const PatchSize& contact) {
    const Grid& grid = setup.grid;
    const double element = std::max(grid.dx, grid.dy);
    return "Elements are " + number_text(element) + " mm wide, " + short_text(element / thinnest(setup.bodies)) +
           " times the thickness of the thinnest layer. A uniform pressure on such an element deforms a nearly "
           "incompressible layer only at the element's rim, so the computed compliance is wrong. Use elements of at "
           "most " +
           short_text(resolving_element(setup, contact)) + " mm";
}

bool is_lost(const ContactSetup& setup, const PatchSize& contact) {
    const auto ratio = compliance_ratio(setup, contact);
    return ratio && !(*ratio > 1 / lost_factor && *ratio < lost_factor);
}

[[noreturn]] void refuse(const ContactSetup& setup, const PatchSize& contact) {
    const Grid& grid = setup.grid;
    throw InvalidArgument(grid.dx >= grid.dy ? "grid.dx" : "grid.dy",
                          "is too large for the layers. " + advice(setup, contact) + ".");
}

}  // namespace

std::optional<double> compliance_ratio(const ContactSetup& setup, const PatchSize& contact) {
    if (!setup.bodies.any_layered()) return {};
    return are_fine(setup) ? 1 : ratio_of(setup.bodies, contact, setup.grid.dx, setup.grid.dy);
}

double compliance_error(double ratio) {
    constexpr double certain = 1;
    return ratio > 0 ? std::min(std::abs(1 / ratio - 1), certain) : certain;
}

std::optional<std::string> layer_warning(const ContactSetup& setup, const PatchSize& contact) {
    if (!setup.bodies.any_layered() || are_fine(setup)) return {};
    const double error = largest_error(setup.bodies, contact, setup.grid.dx, setup.grid.dy);
    if (error < noticed_error) return {};
    std::array<char, 32> percent{};
    std::snprintf(percent.data(), percent.size(), "%.2g %%", 100 * error);
    return advice(setup, contact) +
           ". The error of the normal force for the approach, and of the largest pressure, is about " + percent.data() +
           ".";
}

void require_layers_resolved(const ContactSetup& setup, const PatchSize& contact) {
    if (is_lost(setup, contact)) refuse(setup, contact);
}

void require_layers_resolved(const ContactSetup& setup) {
    const Grid& grid = setup.grid;
    const double length = grid.nx * grid.dx, width = grid.ny * grid.dy;
    if (is_lost(setup, {length, 0}) && is_lost(setup, {0, width})) refuse(setup, {length, width});
}

}  // namespace contactd

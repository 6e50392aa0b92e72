#include "open_table.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "contactd/error.hpp"
#include "creep_table/creep_curves.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using creep_table::CreepFile;

constexpr double rounding_of_nu = 1e-12;

platform::MappedFile map_file(const std::filesystem::path& path) {
    std::error_code missing;
    const std::filesystem::path target = std::filesystem::canonical(path, missing);  // follows links
    platform::MappedFile mapped(missing ? path : target);
    if (mapped.error())
        throw StoreError("Cannot read " + path.filename().string() + ": " + mapped.error().message() + ".");
    return mapped;
}

std::optional<std::size_t> node_of(const CreepFile& file, double nu) {
    for (std::size_t i = 0; i < file.nu.size(); ++i)
        if (std::abs(file.nu[i] - nu) <= rounding_of_nu) return i;
    return std::nullopt;
}

void require_inside(const CreepFile& file, double nu) {
    const double first = file.nu.front(), last = file.nu.back();
    if (file.nu.size() == 1)
        throw InvalidArgument("nu", "is " + number_text(nu) + "; this table holds " + number_text(first) + " only");
    if (!(nu >= first && nu <= last))
        throw InvalidArgument(
            "nu", "is " + number_text(nu) + "; this table holds " + number_text(first) + " to " + number_text(last));
}

/// Returns Lagrange's weights of the nodes.
std::vector<double> weights_at(const std::vector<double>& nodes, double nu) {
    std::vector<double> weights(nodes.size(), 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (i != j) weights[i] *= (nu - nodes[j]) / (nodes[i] - nodes[j]);
    return weights;
}

/// Adds the arrays of all nodes, which follow each other.
std::vector<float> weighted_sum(std::span<const float> arrays, const std::vector<double>& weights) {
    const std::size_t size = arrays.size() / weights.size();
    std::vector<float> sum(size);
    for (std::size_t k = 0; k < size; ++k) {
        double value = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) value += weights[i] * arrays[i * size + k];
        sum[k] = static_cast<float>(value);
    }
    return sum;
}

template <class T>
std::span<const T> share(std::span<const T> arrays, std::size_t index, std::size_t count) {
    const std::size_t size = arrays.size() / count;
    return arrays.subspan(index * size, size);
}

}  // namespace

CreepTable::Contents::Contents(const std::filesystem::path& path, std::optional<double> nu_)
    : mapped(map_file(path)),
      file(creep_table::parse_creep_file(mapped.bytes(), path.filename().string())),
      nu(nu_.value_or(file.nu.front())) {
    spline.grid = file.grid;
    spline.curve_axis = file.curve_axis();
    spline.box = file.box;
    spline.bound_axes = file.bound_axes();
    spline.bounds = file.bounds;
    if (const std::optional<std::size_t> node = node_of(file, nu)) {
        spline.curves = share(file.curves, *node, file.nu.size());
        spline.coefficients = share(file.coefficients, *node, file.nu.size());
        spline.box_coefficients = share(file.box_coefficients, *node, file.nu.size());
        return;
    }
    require_inside(file, nu);
    // Forces are smooth in nu at constant scaled creepages, but the scales of slender contacts are not: 1/(1 - nu).
    const std::vector<double> weights = weights_at(file.nu, nu);
    spline.curves = own_curves = creep_table::creep_curves(spline.curve_axis, nu);
    spline.coefficients = own_coefficients = weighted_sum(file.coefficients, weights);
    spline.box_coefficients = own_box_coefficients = weighted_sum(file.box_coefficients, weights);
}

}  // namespace contactd

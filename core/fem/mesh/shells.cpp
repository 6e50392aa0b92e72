#include "shells.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::fem {
namespace {

/// Returns the position of the layer's outer shell as a fraction of the total thickness, for j = 0..k: geometric growth
/// by f, scaled so that the last layer ends exactly at L.
std::vector<double> fractions(double f, int k) {
    std::vector<double> result(static_cast<std::size_t>(k) + 1);
    for (int j = 0; j <= k; ++j)
        result[static_cast<std::size_t>(j)] =
            f == 1 ? static_cast<double>(j) / k : std::expm1(j * std::log(f)) / std::expm1(k * std::log(f));
    result.back() = 1;
    return result;
}

}  // namespace

Shells make_shells(const IcSpec& spec) {
    const FemSpec& fem = spec.fem;
    const double h = std::sqrt(spec.dx * spec.dy);
    const std::array<double, 3> l{fem.l_over_h * spec.dx, fem.l_over_h * spec.dy, fem.l_over_h * h};
    const double L = fem.L_over_h * std::max(spec.dx, spec.dy);

    Shells shells;
    const MeshSize size = mesh_size(spec);
    shells.m = size.elements_per_edge;
    shells.k = size.layers;
    const std::vector<double> t = fractions(fem.f, shells.k);
    for (std::size_t a = 0; a < 3; ++a)
        for (const double fraction : t) shells.edge[a].push_back(fraction == 1 ? L : l[a] + fraction * (L - l[a]));
    return shells;
}

int element_number(const Shells& shells, const ElementPosition& place) {
    const int m = shells.m;
    const auto& [x, y, z] = place.index;
    if (place.layer == 0) return (x * m + y) * m + z;
    const int first = place.face == 0 ? y : x;
    const int second = place.face == 2 ? y : z;
    return m * m * m + ((place.layer - 1) * 3 + place.face) * m * m + first * m + second;
}

Vertex corner(const Shells& shells, const ElementPosition& place, const std::array<int, 3>& side) {
    Vertex vertex;
    for (std::size_t a = 0; a < 3; ++a) vertex.index[a] = place.index[a] + side[a];
    if (place.layer > 0) {
        const auto face = static_cast<std::size_t>(place.face);
        vertex.index[face] = shells.m;
        vertex.shell = place.layer - 1 + side[face];
    }
    return vertex;
}

std::array<double, 3> position(const Shells& shells, const Vertex& vertex) {
    std::array<double, 3> result;
    for (std::size_t a = 0; a < 3; ++a)
        result[a] = shells.edge[a][static_cast<std::size_t>(vertex.shell)] * vertex.index[a] / shells.m;
    return result;
}

SurfacePoint locate(const Shells& shells, double X, double Y) {
    const std::array<double, 2> point{X, Y};
    const auto outside = [&](int j) {
        return X > shells.edge[0][static_cast<std::size_t>(j)] || Y > shells.edge[1][static_cast<std::size_t>(j)];
    };
    // Returns the smallest shell that contains the point. The search includes the shells, because the offset (1,0) lies
    // on shell 0 if l = h.
    int low = 0, high = shells.k;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (outside(middle))
            low = middle + 1;
        else
            high = middle;
    }

    SurfacePoint result;
    result.place.layer = low;
    std::array<double, 2> edge;  // edge of the box through the point, concentric with the shells
    if (low == 0) {
        edge = {shells.edge[0][0], shells.edge[1][0]};
    } else {
        const auto j = static_cast<std::size_t>(low);
        const auto depth = [&](std::size_t a) {
            return (point[a] - shells.edge[a][j - 1]) / (shells.edge[a][j] - shells.edge[a][j - 1]);
        };
        const std::array<double, 2> t{depth(0), depth(1)};
        result.place.face = t[0] >= t[1] ? 0 : 1;
        const auto face = static_cast<std::size_t>(result.place.face);
        result.local[face] = t[face];
        for (std::size_t a = 0; a < 2; ++a)
            edge[a] = shells.edge[a][j - 1] + t[face] * (shells.edge[a][j] - shells.edge[a][j - 1]);
    }
    for (std::size_t a = 0; a < 2; ++a) {
        if (low > 0 && static_cast<int>(a) == result.place.face) continue;
        const double along = point[a] / edge[a] * shells.m;
        const int index = std::clamp(static_cast<int>(along), 0, shells.m - 1);
        result.place.index[a] = index;
        result.local[a] = std::clamp(along - index, 0.0, 1.0);
    }
    return result;
}

}  // namespace contactd::fem

#include "spectrum_level.hpp"

#include <cmath>

namespace contactd::fem {
namespace {

/// Elements of order three lock above this Poisson's ratio.
constexpr double nearly_incompressible = 0.4;

double length_of(const BoundaryEdge& edge, const DividedOutline& outline) {
    const PlanePoint &a = outline.vertices[static_cast<std::size_t>(edge.first)],
                     &b = outline.vertices[static_cast<std::size_t>(edge.second)];
    return std::hypot(a.y - b.y, a.z - b.z);
}

/// Behind each edge, triangles grow towards the middle of the body, whose thickness is its area divided by the length
/// of its outline.
double triangles_of(const DividedOutline& outline, const MeshDensity& density) {
    constexpr double a_growing_edge = 8.4;  // includes all layers behind it, if there is no other side; measured
    double around = 0, area = 0;
    for (const BoundaryEdge& edge : outline.edges) {
        const PlanePoint &a = outline.vertices[static_cast<std::size_t>(edge.first)],
                         &b = outline.vertices[static_cast<std::size_t>(edge.second)];
        around += length_of(edge, outline);
        area += (a.z * b.y - a.y * b.z) / 2;
    }
    const double depth = std::abs(area) / around;
    double triangles = 0;
    for (const BoundaryEdge& edge : outline.edges) {
        const double grown = density.growth * depth / length_of(edge, outline);
        triangles += a_growing_edge * grown / (1 + grown);
    }
    return triangles;
}

}  // namespace

SpectrumLevel first_level(double accuracy, double nu) {
    const bool stiff = nu > nearly_incompressible;  // resists changes of volume, which require finer elements
    if (accuracy >= 5e-3) return stiff ? SpectrumLevel{4, 3, 13, 1e-2} : SpectrumLevel{3, 4, 13, 1e-2};
    if (accuracy >= 5e-4) return {4, stiff ? 6 : 4, 21, 1e-3};
    return {5, stiff ? 6 : 4, 25, 1e-4};
}

MeshDensity density_for(double accuracy, double nu) {
    const SpectrumLevel level = first_level(accuracy, nu);
    MeshDensity density;
    density.edges_a_strip = level.edges_a_strip;
    density.corner_share = level.corner_share;
    return density;
}

SpectrumSize predicted_spectrum(const SectionOutline& outline, double nu, double accuracy) {
    const SpectrumLevel level = first_level(accuracy, nu);
    const MeshDensity density = density_for(accuracy, nu);
    const DividedOutline divided = divide(outline, density);
    const double p = level.order, triangles = triangles_of(divided, density),
                 edges = static_cast<double>(divided.edges.size());
    SpectrumSize size;
    // Counts nodes on vertices, edges and in triangles, by Euler's formula; each has three unknowns.
    size.unknowns = 3 * (triangles * p * p / 2 + edges * p / 2 + 1);
    // These are measured for two models, of this order and of the next one. Rows become longer with the order.
    constexpr double per_unknown = 1.2e3, shortest_row = 2.7;
    size.model_bytes = per_unknown * (p + shortest_row) * size.unknowns;
    const double n = 3.0 * outline.strips, copies = 4;  // computed, kept, written, and sent to others
    size.spectrum_bytes = copies * sizeof(double) * level.nodes * n * (n + 1) / 2;
    return size;
}

}  // namespace contactd::fem

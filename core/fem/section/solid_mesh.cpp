#include "solid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "contactd/error.hpp"
#include "section_mesh.hpp"

namespace contactd::fem {
namespace {

constexpr double rounding = 1e-9;

/// Returns distances from the middle of the load, ascending from 0.
std::vector<double> slice_lines(const Slices& slices, double finest) {
    constexpr double half_load = 0.5;
    const int under_load = std::max(1, static_cast<int>(std::ceil(half_load / finest - rounding)));
    std::vector<double> lines;
    for (int i = 0; i <= under_load; ++i) lines.push_back(half_load * i / under_load);
    for (double thickness = lines[1] * slices.growth; lines.back() < slices.length; thickness *= slices.growth) {
        const double left = slices.length - lines.back();
        // The last slice includes a remainder that would be too thin for a separate one.
        lines.push_back(left < 1.5 * thickness ? slices.length : lines.back() + thickness);
    }
    return lines;
}

/// Describes where strips lie along y, in the section and in the mesh.
class LevelStrips {
   public:
    LevelStrips(const SectionOutline& outline, const DividedOutline& divided) {
        const auto middle = [&](int strip) {
            return position_at(outline, outline.carrier, outline.first_strip + strip + 0.5);
        };
        const PlanePoint first = point_at(outline, middle(0)), last = point_at(outline, middle(outline.strips - 1));
        const double along = last.y - first.y;
        if (std::abs(along - (outline.strips - 1)) > rounding * outline.strips ||
            std::abs(last.z - first.z) > rounding * divided.extent || normal_at(outline, middle(0)).z < 1 - rounding)
            throw InvalidArgument(
                "ics.section",
                "has strips that do not lie on a horizontal line, which the three-dimensional mesh requires");
        first_ = first.y;
    }
    double mirrored(double y) const { return first_ - y; }

   private:
    double first_ = 0;
};

/// Assigns faces to parts by the edges of the section beneath them.
class Marker {
   public:
    Marker(const DividedOutline& divided, int strip, double length, int layer)
        : divided_(divided), strip_(strip), length_(length), layer_(layer) {
        for (std::size_t i = 0; i < divided.edges.size(); ++i) {
            const auto [low, high] = std::minmax(divided.edges[i].first, divided.edges[i].second);
            edge_of_[{low, high}] = i;
        }
    }

    void mark(mfem::Mesh& mesh) const {
        for (int i = 0; i < mesh.GetNBE(); ++i) mesh.SetBdrAttribute(i, static_cast<int>(part_of(mesh, i)));
        mesh.SetAttributes();
    }

   private:
    BoundaryPart part_of(const mfem::Mesh& mesh, int face) const {
        mfem::Array<int> vertices;
        mesh.GetBdrElementVertices(face, vertices);
        double nearest = length_, farthest = 0;
        int low = layer_, high = 0;
        for (const int vertex : vertices) {
            const double x = -mesh.GetVertex(vertex)[0];
            nearest = std::min(nearest, x);
            farthest = std::max(farthest, x);
            low = std::min(low, vertex % layer_);
            high = std::max(high, vertex % layer_);
        }
        if (farthest == 0) return BoundaryPart::front;
        if (nearest == length_) return BoundaryPart::far;
        const BoundaryEdge& edge = divided_.edges[edge_of_.at({low, high})];
        if (edge.clamped) return BoundaryPart::far;
        constexpr double half_load = 0.5;
        return edge.strip == strip_ && farthest <= half_load * (1 + rounding) ? BoundaryPart::loaded
                                                                              : BoundaryPart::free;
    }

    const DividedOutline& divided_;
    int strip_;
    double length_;
    int layer_;  ///< vertices of a section
    std::map<std::array<int, 2>, std::size_t> edge_of_;
};

mfem::Mesh extrude(const Triangulation& section, const LevelStrips& strips, const std::vector<double>& lines) {
    const auto count = static_cast<int>(section.vertices.size()), slices = static_cast<int>(lines.size()) - 1;
    mfem::Mesh mesh(3, count * (slices + 1), static_cast<int>(section.triangles.size()) * slices);
    for (const double x : lines)
        for (const PlanePoint& vertex : section.vertices) mesh.AddVertex(-x, strips.mirrored(vertex.y), vertex.z);
    for (int slice = 0; slice < slices; ++slice)
        for (const auto& [a, b, c] : section.triangles) {
            // Vertices are anticlockwise in the section and clockwise in its mirror image, because the extrusion runs
            // towards negative x.
            const int near = slice * count, far = near + count;
            mesh.AddWedge(near + a, near + b, near + c, far + a, far + b, far + c);
        }
    mesh.FinalizeTopology();  // makes the boundary elements
    return mesh;
}

}  // namespace

BlockMesh make_solid_mesh(const SectionOutline& outline, const DividedOutline& divided,
                          const Triangulation& triangulation, int strip, const Slices& slices) {
    const LevelStrips strips(outline, divided);
    const std::vector<EdgeElement> elements = elements_of_edges(divided, triangulation);
    double finest = 1;
    std::vector<std::size_t> carriers;
    for (std::size_t i = 0; i < divided.edges.size(); ++i) {
        if (divided.edges[i].strip < 0) continue;
        carriers.push_back(i);
        finest = std::min(finest, divided.edges[i].to - divided.edges[i].from);
    }
    const std::vector<double> lines = slice_lines(slices, finest);

    BlockMesh result;
    result.mesh = extrude(triangulation, strips, lines);
    Marker(divided, strip, lines.back(), static_cast<int>(triangulation.vertices.size())).mark(result.mesh);
    // Neither refinement nor a correction of orientations may reorder the elements, because locate() depends on the
    // order.
    result.mesh.Finalize(false, false);

    std::vector<double> ends{-strips.mirrored(divided.vertices[divided.edges[carriers.front()].first].y)};
    std::vector<EdgeElement> on_strips;
    for (const std::size_t i : carriers) {
        ends.push_back(-strips.mirrored(divided.vertices[divided.edges[i].second].y));
        on_strips.push_back(elements[i]);
    }
    result.locate = [=, triangles = static_cast<int>(triangulation.triangles.size())](double X, double Y) {
        const Interval slice = find_interval(lines, X), edge = find_interval(ends, Y);
        const EdgeElement& at = on_strips[static_cast<std::size_t>(edge.number)];
        ElementPoint point{slice.number * triangles + at.element, at.at(edge.local)};
        point.point.z = slice.local;
        return point;
    };
    return result;
}

}  // namespace contactd::fem

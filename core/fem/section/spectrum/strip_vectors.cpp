#include "strip_vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace contactd::fem {
namespace {

using Frame = std::array<std::array<double, 3>, 3>;

/// Directions x, s, n in the unknowns w, v, t.
Frame frame_of(const PlanePoint& normal) {
    return {{{1, 0, 0}, {0, normal.z, -normal.y}, {0, normal.y, normal.z}}};
}

class Gatherer {
   public:
    explicit Gatherer(const WaveMatrices& matrices) : matrices_(matrices) {}

    /// Returns shape functions at a point of an edge, times `weight`, along the three directions.
    void add(const EdgeElement& edge, double t, const PlanePoint& normal, double weight) {
        const mfem::FiniteElement& element = *matrices_.space().GetFE(edge.element);
        mfem::Vector shape(element.GetDof());
        element.CalcShape(edge.at(t), shape);
        mfem::Array<int> dofs;
        matrices_.space().GetElementDofs(edge.element, dofs);
        const Frame frame = frame_of(normal);
        for (int a = 0; a < dofs.Size(); ++a) {
            const int row = matrices_.unknown(dofs[a]);
            if (row < 0 || std::abs(shape[a]) < 1e-14) continue;
            for (int i = 0; i < 3; ++i)
                for (int c = 0; c < 3; ++c)
                    if (frame[i][c] != 0) sums_[i][row + c] += weight * shape[a] * frame[i][c];
        }
    }
    void move_to(SparseColumns& result) {
        for (auto& sum : sums_) {
            auto& column = result.columns.emplace_back();
            for (const auto& [row, value] : sum) column.push_back({row, value});
            sum.clear();
        }
    }

   private:
    const WaveMatrices& matrices_;
    std::array<std::map<int, double>, 3> sums_;
};

std::vector<std::vector<std::size_t>> edges_of_strips(const SectionOutline& outline, const SectionMesh& mesh) {
    std::vector<std::vector<std::size_t>> result(static_cast<std::size_t>(outline.strips));
    for (std::size_t edge = 0; edge < mesh.outline.edges.size(); ++edge)
        if (const int strip = mesh.outline.edges[edge].strip; strip >= 0) result[strip].push_back(edge);
    return result;
}

}  // namespace

SparseColumns strip_loads(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices) {
    SparseColumns result;
    Gatherer gatherer(matrices);
    const mfem::IntegrationRule& rule =
        mfem::IntRules.Get(mfem::Geometry::SEGMENT, 2 * matrices.space().GetMaxElementOrder() + 2);
    for (const auto& edges : edges_of_strips(outline, mesh)) {
        for (const std::size_t number : edges) {
            const BoundaryEdge& edge = mesh.outline.edges[number];
            const OutlinePiece& piece = outline.loops[edge.loop][edge.piece];
            for (int q = 0; q < rule.GetNPoints(); ++q) {
                const double t = rule.IntPoint(q).x;
                gatherer.add(mesh.edge_elements[number], t, piece.normal(edge.from + t * (edge.to - edge.from)),
                             rule.IntPoint(q).weight * (edge.to - edge.from));
            }
        }
        gatherer.move_to(result);
    }
    return result;
}

SparseColumns strip_observations(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices) {
    SparseColumns result;
    Gatherer gatherer(matrices);
    const auto edges = edges_of_strips(outline, mesh);
    for (std::size_t strip = 0; strip < edges.size(); ++strip) {
        const OutlinePosition middle =
            position_at(outline, outline.carrier, outline.first_strip + static_cast<double>(strip) + 0.5);
        std::size_t nearest = edges[strip].front();
        double t = 0, least = 1e300;
        for (const std::size_t number : edges[strip]) {
            const BoundaryEdge& edge = mesh.outline.edges[number];
            if (edge.piece != middle.piece) continue;
            const double at = (middle.s - edge.from) / (edge.to - edge.from), inside = std::clamp(at, 0.0, 1.0);
            if (std::abs(at - inside) < least) {
                least = std::abs(at - inside);
                nearest = number;
                t = inside;
            }
        }
        gatherer.add(mesh.edge_elements[nearest], t, normal_at(outline, middle), 1);
        gatherer.move_to(result);
    }
    return result;
}

}  // namespace contactd::fem

#include "section_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>

#include "contactd/error.hpp"

namespace contactd::fem {
namespace {

constexpr std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};

[[noreturn]] void refuse(const char* what, const PlanePoint& where) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%s at (y, z) = (%.6g, %.6g) ds", what, where.y, where.z);
    throw InvalidArgument("ics.section", text.data());
}

/// Moves the nodes of the triangle at an edge by the distance of the outline from the edge's chord. The displacement
/// decreases towards the opposite corner such that a parabola is reproduced exactly.
void curve(mfem::Mesh& mesh, const OutlinePiece& piece, const BoundaryEdge& edge, const EdgeElement& at) {
    const mfem::FiniteElementSpace& space = *mesh.GetNodalFESpace();
    mfem::Array<int> dofs;
    space.GetElementDofs(at.element, dofs);
    const mfem::IntegrationRule& nodes = space.GetFE(at.element)->GetNodes();
    const PlanePoint begin = piece.point(edge.from), end = piece.point(edge.to);
    for (int i = 0; i < dofs.Size(); ++i) {
        const mfem::IntegrationPoint& node = nodes.IntPoint(i);
        const std::array<double, 3> weights{1 - node.x - node.y, node.x, node.y};
        const double first = weights[at.first], second = weights[at.second];
        if (first < 1e-12 || second < 1e-12) continue;
        const double t = (1 + second - first) / 2, fading = first * second / (t * (1 - t));
        const PlanePoint true_point = piece.point(edge.from + t * (edge.to - edge.from));
        const std::array<double, 2> shift{true_point.y - (1 - t) * begin.y - t * end.y,
                                          true_point.z - (1 - t) * begin.z - t * end.z};
        for (int component = 0; component < 2; ++component)
            (*mesh.GetNodes())(space.DofToVDof(dofs[i], component)) += fading * shift[component];
    }
}

void require_straight_enough(mfem::Mesh& mesh, const DividedOutline& outline, const std::vector<EdgeElement>& edges) {
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        mfem::ElementTransformation& map = *mesh.GetElementTransformation(edges[edge].element);
        const mfem::IntegrationRule& rule = mfem::IntRules.Get(mfem::Geometry::TRIANGLE, 8);
        for (int i = 0; i < rule.GetNPoints(); ++i) {
            map.SetIntPoint(&rule.IntPoint(i));
            if (map.Jacobian().Det() > 0) continue;
            refuse("is too strongly curved for a mesh", outline.vertices[outline.edges[edge].first]);
        }
    }
}

}  // namespace

std::vector<EdgeElement> elements_of_edges(const DividedOutline& outline, const Triangulation& triangulation) {
    std::map<std::array<int, 2>, std::size_t> edge_of;
    for (std::size_t edge = 0; edge < outline.edges.size(); ++edge)
        edge_of[{outline.edges[edge].first, outline.edges[edge].second}] = edge;
    std::vector<EdgeElement> result(outline.edges.size());
    for (std::size_t element = 0; element < triangulation.triangles.size(); ++element)
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
                const auto& triangle = triangulation.triangles[element];
                const auto found = edge_of.find({triangle[a], triangle[b]});
                if (a != b && found != edge_of.end()) result[found->second] = {static_cast<int>(element), a, b};
            }
    for (std::size_t edge = 0; edge < result.size(); ++edge)
        if (result[edge].element < 0)
            refuse("could not be divided into triangles", outline.vertices[outline.edges[edge].first]);
    return result;
}

mfem::IntegrationPoint EdgeElement::at(double t) const {
    mfem::IntegrationPoint point;
    point.Set2((1 - t) * corners[first][0] + t * corners[second][0],
               (1 - t) * corners[first][1] + t * corners[second][1]);
    return point;
}

SectionMesh make_section_mesh(const SectionOutline& outline, const DividedOutline& divided,
                              const Triangulation& triangulation, int order) {
    auto mesh = std::make_unique<mfem::Mesh>(2, static_cast<int>(triangulation.vertices.size()),
                                             static_cast<int>(triangulation.triangles.size()),
                                             static_cast<int>(divided.edges.size()));
    for (const PlanePoint& vertex : triangulation.vertices) mesh->AddVertex(vertex.y, vertex.z);
    for (const auto& triangle : triangulation.triangles) mesh->AddTriangle(triangle.data());
    for (const BoundaryEdge& edge : divided.edges) mesh->AddBdrSegment(edge.first, edge.second, edge.clamped ? 2 : 1);
    mesh->FinalizeTriMesh(1, 0, false);
    mesh->SetCurvature(order);
    SectionMesh result{std::move(mesh), divided, elements_of_edges(divided, triangulation)};
    for (std::size_t edge = 0; edge < divided.edges.size(); ++edge) {
        const BoundaryEdge& one = divided.edges[edge];
        curve(*result.mesh, outline.loops[one.loop][one.piece], one, result.edge_elements[edge]);
    }
    require_straight_enough(*result.mesh, divided, result.edge_elements);
    return result;
}

}  // namespace contactd::fem

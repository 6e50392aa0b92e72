// Fills outlines by gmsh, as a module. A program opens it when it first meshes a section, because loading gmsh's
// libraries takes a third of a second and 70 MB.
#include <gmsh.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>

#include "mesher.hpp"

namespace contactd::fem {
namespace {

class Gmsh {
   public:
    Gmsh() {
        gmsh::initialize(0, nullptr, false, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
        gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
        constexpr int frontal_delaunay = 6;  // produces the most regular triangles
        gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay);
        gmsh::model::add("section");
    }
    ~Gmsh() { gmsh::finalize(); }
    Gmsh(const Gmsh&) = delete;
    Gmsh& operator=(const Gmsh&) = delete;
};

void add_outline(const DividedOutline& outline) {
    for (std::size_t i = 0; i < outline.vertices.size(); ++i)
        gmsh::model::geo::addPoint(outline.vertices[i].y, outline.vertices[i].z, 0, 0, static_cast<int>(i) + 1);
    std::vector<int> loops;
    for (std::size_t loop = 0; loop + 1 < outline.loop_begin.size(); ++loop) {
        std::vector<int> lines;
        for (int edge = outline.loop_begin[loop]; edge < outline.loop_begin[loop + 1]; ++edge)
            lines.push_back(gmsh::model::geo::addLine(outline.edges[edge].first + 1, outline.edges[edge].second + 1));
        loops.push_back(gmsh::model::geo::addCurveLoop(lines));
    }
    gmsh::model::geo::addPlaneSurface(loops);
    gmsh::model::geo::synchronize();
    for (std::size_t line = 1; line <= outline.edges.size(); ++line)
        gmsh::model::mesh::setTransfiniteCurve(static_cast<int>(line), 2);
}

Triangulation result_of(const DividedOutline& outline) {
    Triangulation result{outline.vertices, {}};
    std::vector<std::size_t> tags;
    std::vector<double> places, parameters;
    gmsh::model::mesh::getNodes(tags, places, parameters);
    std::unordered_map<std::size_t, int> vertex;
    std::vector<std::size_t> of_point;
    std::vector<double> ignored;
    for (std::size_t i = 0; i < outline.vertices.size(); ++i) {
        gmsh::model::mesh::getNodes(of_point, ignored, parameters, 0, static_cast<int>(i) + 1);
        vertex[of_point.at(0)] = static_cast<int>(i);
    }
    for (std::size_t node = 0; node < tags.size(); ++node)
        if (vertex.try_emplace(tags[node], static_cast<int>(result.vertices.size())).second)
            result.vertices.push_back({places[3 * node], places[3 * node + 1]});
    std::vector<std::size_t> elements, triangles;  // is empty, because gmsh treats other points as part of the domain
    gmsh::model::mesh::getElementsByType(2, elements, triangles);
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        std::array<int, 3> corner{vertex.at(triangles[i]), vertex.at(triangles[i + 1]), vertex.at(triangles[i + 2])};
        const PlanePoint &a = result.vertices[corner[0]], &b = result.vertices[corner[1]],
                         &c = result.vertices[corner[2]];
        if ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y) < 0) std::swap(corner[1], corner[2]);
        result.triangles.push_back(corner);
    }
    return result;
}

}  // namespace
}  // namespace contactd::fem

extern "C" bool contactd_fill_outline(const contactd::fem::DividedOutline& outline, const contactd::fem::SizeAt& size,
                                      contactd::fem::Triangulation& result, std::string& problem) try {
    using namespace contactd::fem;
    const Gmsh library;
    add_outline(outline);
    gmsh::model::mesh::setSizeCallback([&](int, int, double y, double z, double, double) { return size({y, z}); });
    gmsh::model::mesh::generate(2);
    result = result_of(outline);
    return true;
} catch (const std::exception& error) {  // gmsh throws its last message, or std::runtime_error with that message.
    problem = error.what();
    return false;
}

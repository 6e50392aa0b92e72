// The mesh of a section: triangles whose edges on the outline lie on it, to the order of the elements.
#pragma once

#include <memory>
#include <vector>

#include <mfem.hpp>

#include "triangulation.hpp"

namespace contactd::fem {

/// The triangle of an edge of the outline, and the corners of it at which the edge begins and ends.
struct EdgeElement {
    int element = -1;
    int first = 0, second = 0;

    /// Reference point of the share t, 0 to 1, along the edge.
    mfem::IntegrationPoint at(double t) const;
};

/// Finds the triangle of each edge of the outline. Throws InvalidArgument ("ics.section") where one has none.
std::vector<EdgeElement> elements_of_edges(const DividedOutline& outline, const Triangulation& triangulation);

struct SectionMesh {
    std::unique_ptr<mfem::Mesh> mesh;  ///< coordinates (y, z), isoparametric of `order`
    DividedOutline outline;
    std::vector<EdgeElement> edge_elements;  ///< of each edge of `outline`
};

/// Throws InvalidArgument ("ics.section") when the outline curves too much for its triangles.
SectionMesh make_section_mesh(const SectionOutline& outline, const DividedOutline& divided,
                              const Triangulation& triangulation, int order);

}  // namespace contactd::fem

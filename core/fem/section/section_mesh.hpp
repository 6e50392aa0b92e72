// Makes the mesh of a section: triangles whose edges follow the outline to the order of the elements.
#pragma once

#include <memory>
#include <vector>

#include <mfem.hpp>

#include "triangulation.hpp"

namespace contactd::fem {

/// Holds the triangle of an edge of the outline, and its corners at the start and the end of the edge.
struct EdgeElement {
    int element = -1;
    int first = 0, second = 0;

    /// Returns the reference point at the fraction t, 0 to 1, of the edge.
    mfem::IntegrationPoint at(double t) const;
};

/// Finds the triangle of each edge of the outline. Throws InvalidArgument ("ics.section") for an edge without one.
std::vector<EdgeElement> elements_of_edges(const DividedOutline& outline, const Triangulation& triangulation);

struct SectionMesh {
    std::unique_ptr<mfem::Mesh> mesh;  ///< coordinates (y, z), isoparametric of `order`
    DividedOutline outline;
    std::vector<EdgeElement> edge_elements;  ///< one for each edge of `outline`
};

/// Throws InvalidArgument ("ics.section") if the outline is too curved for its triangles.
SectionMesh make_section_mesh(const SectionOutline& outline, const DividedOutline& divided,
                              const Triangulation& triangulation, int order);

}  // namespace contactd::fem

#include "refined_block.hpp"

#include <algorithm>

namespace contactd::fem {
namespace {

/// Holds the element's place in its parent element; reference axes are inherited.
ReferenceBox box_in_parent(const mfem::DenseMatrix& corners) {
    constexpr int first = 0, opposite = 6;
    ReferenceBox box;
    for (int a = 0; a < 3; ++a) {
        box.low[static_cast<std::size_t>(a)] = corners(a, first);
        box.size[static_cast<std::size_t>(a)] = corners(a, opposite) - corners(a, first);
    }
    return box;
}

ReferenceBox nested(const ReferenceBox& outer, const ReferenceBox& inner) {
    ReferenceBox result{outer.ancestor, {}, {}};
    for (std::size_t a = 0; a < 3; ++a) {
        result.low[a] = outer.low[a] + outer.size[a] * inner.low[a];
        result.size[a] = outer.size[a] * inner.size[a];
    }
    return result;
}

bool holds(const ReferenceBox& box, double xi, double eta) {
    return box.low[0] <= xi && xi <= box.low[0] + box.size[0] && box.low[1] <= eta && eta <= box.low[1] + box.size[1];
}

struct SurfaceElement {
    int number;
    ReferenceBox box;
};

}  // namespace

RefinedBlock::RefinedBlock(BlockMesh start) : mesh_(std::move(start.mesh)), locate_(std::move(start.locate)) {
    for (int i = 0; i < mesh_.GetNE(); ++i) boxes_.push_back({i});
    mesh_.EnsureNCMesh();
}

void RefinedBlock::refine(const std::vector<int>& elements) {
    mfem::Array<int> numbers;
    for (const int element : elements) numbers.Append(element);
    mesh_.GeneralRefinement(numbers);
    const mfem::CoarseFineTransformations& divisions = mesh_.GetRefinementTransforms();
    std::vector<ReferenceBox> refined;
    for (const mfem::Embedding& place : divisions.embeddings) {
        const ReferenceBox box =
            box_in_parent(divisions.point_matrices[mfem::Geometry::CUBE](static_cast<int>(place.matrix)));
        refined.push_back(nested(boxes_[static_cast<std::size_t>(place.parent)], box));
    }
    boxes_ = std::move(refined);
}

BlockMesh RefinedBlock::block() const {
    std::vector<std::vector<SurfaceElement>> on_surface;  // one for each element of the start mesh
    for (int i = 0; i < mesh().GetNE(); ++i) {
        const ReferenceBox& box = boxes_[static_cast<std::size_t>(i)];
        if (box.low[2] != 0) continue;
        const auto ancestor = static_cast<std::size_t>(box.ancestor);
        on_surface.resize(std::max(on_surface.size(), ancestor + 1));
        on_surface[ancestor].push_back({i, box});
    }
    const auto locate = [find = locate_, on_surface = std::move(on_surface)](double X, double Y) {
        const auto [ancestor, point] = find(X, Y);
        const auto& elements = on_surface[static_cast<std::size_t>(ancestor)];
        const auto found = std::find_if(elements.begin(), elements.end(),
                                        [&](const SurfaceElement& one) { return holds(one.box, point.x, point.y); });
        ElementPoint result{found->number, {}};
        const auto local = [&](double at, std::size_t a) {
            return std::clamp((at - found->box.low[a]) / found->box.size[a], 0.0, 1.0);
        };
        result.point.Set3(local(point.x, 0), local(point.y, 1), 0);
        return result;
    };
    return {mfem::Mesh(mesh()), locate};
}

}  // namespace contactd::fem

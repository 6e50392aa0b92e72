#include "sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace contactd::fem {
namespace {

/// Is one at nodes[i], and decreases linearly to zero at its neighbours.
double hat(double at, int i, const double* nodes, int count) {
    const double own = nodes[i], neighbour = at < own ? (i > 0 ? nodes[i - 1] : own) : (i < count ? nodes[i + 1] : own);
    if (at == own) return 1;
    return neighbour == own ? 0 : std::max(0.0, (neighbour - at) / (neighbour - own));
}

/// Interpolates between the nodes of a square face, of order p, by products of hats over Gauss-Lobatto points.
class FaceHats {
   public:
    explicit FaceHats(int order) : order_(order), nodes_(mfem::poly1d.ClosedPoints(order)) {}
    double operator()(double at, double node) const {
        int nearest = 0;
        for (int i = 1; i <= order_; ++i)
            if (std::abs(nodes_[i] - node) < std::abs(nodes_[nearest] - node)) nearest = i;
        return hat(at, nearest, nodes_, order_);
    }

   private:
    int order_;
    const double* nodes_;
};

/// Holds the place on the surface face of an element: two coordinates, and whether the point is on the face at all.
struct OnFace {
    double s, t;
    bool on;
};

/// The surface is the face zeta = 0 of hexahedra. For prisms it is the square face on which the barycentric coordinate
/// `opposite` vanishes.
OnFace on_face(const mfem::IntegrationPoint& point, mfem::Geometry::Type geometry, int opposite) {
    constexpr double rounding = 1e-9;
    if (geometry == mfem::Geometry::CUBE) return {point.x, point.y, point.z < rounding};
    const std::array<double, 3> barycentric{1 - point.x - point.y, point.x, point.y};
    const auto next = static_cast<std::size_t>(opposite == 2 ? 1 : 2);
    return {barycentric[next], point.z, std::abs(barycentric[static_cast<std::size_t>(opposite)]) < rounding};
}

int vanishing_coordinate(const mfem::IntegrationPoint& point) {
    const std::array<double, 3> barycentric{1 - point.x - point.y, point.x, point.y};
    return static_cast<int>(std::min_element(barycentric.begin(), barycentric.end()) - barycentric.begin());
}

/// Returns weights of an element's nodes at a surface point: its shape functions, or hats between the vertices or
/// between all nodes of its surface face. The latter reproduces the paper's figures.
class Weights {
   public:
    explicit Weights(Sampling sampling) : sampling_(sampling) {}
    const mfem::Vector& at(const mfem::FiniteElement& element, const mfem::IntegrationPoint& point) {
        weights_.SetSize(element.GetDof());
        if (sampling_ == Sampling::fem) {
            element.CalcShape(point, weights_);
            return weights_;
        }
        const FaceHats hats(sampling_ == Sampling::linear ? 1 : element.GetOrder());
        const mfem::Geometry::Type geometry = element.GetGeomType();
        const int opposite = vanishing_coordinate(point);
        const OnFace here = on_face(point, geometry, opposite);
        const int vertices = mfem::Geometry::NumVerts[geometry];
        for (int i = 0; i < weights_.Size(); ++i) {
            const OnFace node = on_face(element.GetNodes()[i], geometry, opposite);
            const bool counts = node.on && (sampling_ == Sampling::linear_nodes || i < vertices);
            weights_[i] = counts ? hats(here.s, node.s) * hats(here.t, node.t) : 0;
        }
        return weights_;
    }

   private:
    Sampling sampling_;
    mfem::Vector weights_;
};

Axis mirrored(Axis axis) {
    return axis == Axis::x ? Axis::y : axis == Axis::y ? Axis::x : Axis::z;
}

/// Returns displacements of one load case at surface points, read from the elements of this process.
class Displacements {
   public:
    Displacements(ElasticityProblem& problem, const mfem::Vector& true_dofs, Sampling sampling)
        : problem_(problem), u_(&problem.space()), weights_(sampling) {
        u_.SetFromTrueDofs(true_dofs);
    }
    /// Returns the value at (-X, -Y, 0), or zero if another process has the point.
    std::array<double, 3> at(double X, double Y) {
        std::array<double, 3> result{};
        const auto [element, point] = problem_.locate(X, Y);
        if (element < 0) return result;
        if (element != nodes_of_) u_.GetElementDofValues(element, nodes_);
        nodes_of_ = element;
        const mfem::Vector& weight = weights_.at(*problem_.space().GetFE(element), point);
        const int count = weight.Size();
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int i = 0; i < count; ++i) result[axis] += weight[i] * nodes_[static_cast<int>(axis) * count + i];
        return result;
    }

   private:
    ElasticityProblem& problem_;
    mfem::ParGridFunction u_;
    Weights weights_;
    mfem::Vector nodes_;  // data of the last element, because successive points of a row are close
    int nodes_of_ = -1;
};

/// Adds values of one case in the elements of this process to `table`.
void sample_case(ElasticityProblem& problem, const IcSpec& spec, const SolvedCase& solved, IcTable& table) {
    Displacements displacements(problem, *solved.true_dofs, spec.fem.sampling);
    const bool mirror = solved.solved != solved.load;
    for (int l = 0; l < spec.ny; ++l)
        for (int k = 0; k < spec.nx; ++k) {
            const double X = k * spec.dx, Y = l * spec.dy;
            const auto value = mirror ? displacements.at(Y, X) : displacements.at(X, Y);
            for (const Axis read : {Axis::x, Axis::y, Axis::z}) {
                const Axis displacement = mirror ? mirrored(read) : read;
                // The block is the quarter of negative x and y, but the table has positive offsets.
                const auto [along_x, along_y] = parity(displacement, solved.load);
                table(displacement, solved.load, k, l) += along_x * along_y * value[static_cast<std::size_t>(read)];
            }
        }
}

void sum_over_processes(UnsetArray& values, MPI_Comm comm) {
    constexpr std::size_t chunk = std::size_t{1} << 24;  // MPI counts are ints.
    for (std::size_t at = 0; at < values.size(); at += chunk)
        MPI_Allreduce(MPI_IN_PLACE, values.data() + at, static_cast<int>(std::min(chunk, values.size() - at)),
                      MPI_DOUBLE, MPI_SUM, comm);
}

}  // namespace

IcTable sample_table(ElasticityProblem& problem, const IcSpec& spec, const std::vector<SolvedCase>& cases) {
    IcTable table(spec.nx, spec.ny);
    for (const SolvedCase& solved : cases) sample_case(problem, spec, solved, table);
    sum_over_processes(table.values, problem.space().GetComm());
    return table;
}

}  // namespace contactd::fem

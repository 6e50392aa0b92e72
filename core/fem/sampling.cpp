#include "sampling.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::fem {
namespace {

/// One at `node`, falling to zero at its neighbours; zero everywhere for a node between the ends of an interval.
double hat(double at, double node, int intervals) {
    const double place = node * intervals;
    return place == std::round(place) ? std::max(0.0, 1 - std::abs(at * intervals - place)) : 0.0;
}

/// Weights of an element's nodes at a surface point: its shape functions, or hats between neighbours (nodes of order 1
/// and 2 are evenly spaced): between the corners, or between all nodes. The latter gives the paper's figures.
class Weights {
   public:
    Weights(const mfem::FiniteElement& element, Sampling sampling) : element_(element), sampling_(sampling) {
        weights_.SetSize(element.GetDof());
    }
    const mfem::Vector& at(const mfem::IntegrationPoint& point) {
        if (sampling_ == Sampling::fem) {
            element_.CalcShape(point, weights_);
        } else {
            const int intervals = sampling_ == Sampling::linear ? 1 : element_.GetOrder();
            for (int i = 0; i < weights_.Size(); ++i) {
                const mfem::IntegrationPoint& node = element_.GetNodes()[i];
                weights_[i] =
                    hat(point.x, node.x, intervals) * hat(point.y, node.y, intervals) * hat(point.z, node.z, intervals);
            }
        }
        return weights_;
    }

   private:
    const mfem::FiniteElement& element_;
    Sampling sampling_;
    mfem::Vector weights_;
};

Axis mirrored(Axis axis) {
    return axis == Axis::x ? Axis::y : axis == Axis::y ? Axis::x : Axis::z;
}

/// Values of one case in the elements of this process, added to `table`.
void sample_case(ElasticityProblem& problem, const IcSpec& spec, const SolvedCase& solved, IcTable& table) {
    mfem::ParFiniteElementSpace& space = problem.space();
    mfem::ParGridFunction u(&space);
    u.SetFromTrueDofs(*solved.true_dofs);
    Weights weights(*space.GetFE(0), spec.fem.sampling);
    const bool mirror = solved.solved != solved.load;

    mfem::Vector nodes;  // of the element read last: points of a row follow each other
    int nodes_of = -1;
    for (int l = 0; l < spec.ny; ++l)
        for (int k = 0; k < spec.nx; ++k) {
            const double X = k * spec.dx, Y = l * spec.dy;
            const SurfacePoint point = mirror ? locate(problem.shells(), Y, X) : locate(problem.shells(), X, Y);
            const int element = problem.local_element(element_number(problem.shells(), point.place));
            if (element < 0) continue;
            if (element != nodes_of) u.GetElementDofValues(element, nodes);
            nodes_of = element;
            const mfem::Vector& weight = weights.at(reference_point(point));
            const int count = weight.Size();
            for (const Axis read : {Axis::x, Axis::y, Axis::z}) {
                double value = 0;
                for (int i = 0; i < count; ++i) value += weight[i] * nodes[static_cast<int>(read) * count + i];
                const Axis displacement = mirror ? mirrored(read) : read;
                // The block is the quarter of negative x and y, the table that of positive offsets.
                const auto [along_x, along_y] = parity(displacement, solved.load);
                table(displacement, solved.load, k, l) += along_x * along_y * value;
            }
        }
}

void sum_over_processes(std::vector<double>& values, MPI_Comm comm) {
    constexpr std::size_t chunk = std::size_t{1} << 24;  // counts are ints in MPI
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

// Solves the paper's system of equations for one load on one of its meshes, by conjugate gradients with an incomplete
// factorisation, as in the paper:
//
//     block_system --preset paper-test3 [--L_over_h 1280] [--h_over_hs 4] [--order 2] [--load z]
//                  [--preconditioner ilu0|ic] [--numbering outward|inward|mfem|rcm] [--condensed 0|1]
//
// It prints one JSON object for `./dev paper fem`; seconds are processor time. With --mesh FILE it writes the mesh in
// MFEM's format and solves nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <string>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/half_space.hpp"
#include "system/condensed_assembly.hpp"
#include "system/element_stiffness.hpp"

namespace {

using namespace contactd;
using namespace contactd::fem;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
using Vector = Eigen::VectorXd;
using Options = std::map<std::string, std::string>;

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Returns the stiffness matrix with rows 3 number[node] + axis; a node without a number was eliminated.
struct Stiffness {
    std::vector<int> number;
    Matrix matrix;  ///< both halves
};

Stiffness whole(ElasticityProblem& problem) {
    mfem::ParFiniteElementSpace& space = problem.space();
    mfem::BilinearForm form(&space);
    mfem::Array<int> dofs;
    const auto add = [&](int element, Eigen::MatrixXd values) {
        const auto size = static_cast<int>(values.rows());
        form.AssembleElementMatrix(element, mfem::DenseMatrix(values.data(), size, size), dofs);
    };
    for_each_stiffness(space, problem.spec().material, add, [](double, double) {});
    form.Finalize();
    mfem::SparseMatrix& sparse = form.SpMat();
    sparse.SortColumnIndices();
    Stiffness result;
    result.number.resize(static_cast<std::size_t>(space.GetNDofs()));
    std::iota(result.number.begin(), result.number.end(), 0);
    result.matrix = Eigen::Map<const Matrix>(sparse.Height(), sparse.Width(), sparse.NumNonZeroElems(), sparse.GetI(),
                                             sparse.GetJ(), sparse.GetData());
    return result;
}

Stiffness condensed(ElasticityProblem& problem) {
    CondensedAssembly assembly(problem.space());
    const Eigen::SparseMatrix<double> lower = assembly.assemble(problem.spec().material, [](double, double) {});
    return {assembly.node_numbers(), Matrix(Eigen::SparseMatrix<double>(lower.selfadjointView<Eigen::Lower>()))};
}

using Position = std::array<double, 3>;

std::vector<Position> node_positions(ElasticityProblem& problem) {
    mfem::ParGridFunction at(&problem.space());
    mfem::VectorFunctionCoefficient identity(3, [](const mfem::Vector& x, mfem::Vector& value) { value = x; });
    at.ProjectCoefficient(identity);
    std::vector<Position> result(static_cast<std::size_t>(problem.space().GetNDofs()));
    for (std::size_t node = 0; node < result.size(); ++node)
        for (int i = 0; i < 3; ++i) result[node][static_cast<std::size_t>(i)] = at[3 * static_cast<int>(node) + i];
    return result;
}

/// Returns the nodes in the order of their equations; "outward" orders them shell by shell from the load.
std::vector<int> node_order(const std::string& numbering, const std::vector<Position>& positions) {
    std::vector<int> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    if (numbering != "outward" && numbering != "inward") return order;
    const auto key = [&](int node) {
        const auto [x, y, z] = positions[static_cast<std::size_t>(node)];
        const auto rounded = [](double value) { return std::round(value * 1e9); };
        return std::array{rounded(std::max({-x, -y, -z})), rounded(-z), rounded(-y), rounded(-x)};
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    if (numbering == "inward") std::reverse(order.begin(), order.end());
    return order;
}

struct System {
    Matrix A;
    Vector b;
    int observed = -1;  ///< row of the displacement under the load, along it
};

/// Returns the equations for the unknown displacements; the prescribed ones are zero.
System free_system(ElasticityProblem& problem, const Stiffness& stiffness, Axis load, const std::string& numbering) {
    const LoadCase load_case = problem.load_case(load);
    const std::vector<Position> positions = node_positions(problem);
    std::vector<char> given(3 * positions.size(), 0);
    for (const int dof : load_case.essential) given[static_cast<std::size_t>(dof)] = 1;
    std::vector<int> place(static_cast<std::size_t>(stiffness.matrix.rows()), -1);
    std::vector<double> forces;
    System result;
    for (const int node : node_order(numbering, positions)) {
        const int number = stiffness.number[static_cast<std::size_t>(node)];
        for (int i = 0; i < 3 && number >= 0; ++i) {
            if (given[static_cast<std::size_t>(3 * node + i)]) continue;
            if (positions[static_cast<std::size_t>(node)] == Position{} && i == static_cast<int>(load))
                result.observed = static_cast<int>(forces.size());
            place[static_cast<std::size_t>(3 * number + i)] = static_cast<int>(forces.size());
            forces.push_back(load_case.forces[3 * node + i]);
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < stiffness.matrix.rows(); ++row)
        for (Matrix::InnerIterator entry(stiffness.matrix, row); entry; ++entry)
            if (const int at = place[static_cast<std::size_t>(row)], to = place[static_cast<std::size_t>(entry.col())];
                at >= 0 && to >= 0)
                entries.emplace_back(at, to, entry.value());
    const auto size = static_cast<Eigen::Index>(forces.size());
    result.A.resize(size, size);
    result.A.setFromTriplets(entries.begin(), entries.end());
    result.b = Eigen::Map<const Vector>(forces.data(), size);
    return result;
}

using Preconditioner = std::function<void(const Vector& r, Vector& z)>;

/// Returns the ILU(0) of hypre, which renumbers the equations for "rcm".
Preconditioner ilu0(const Matrix& A, bool reorder) {
    struct Factor {
        Matrix values;  // hypre moves the diagonal to the front, in place
        mfem::SparseMatrix sparse;
        HYPRE_BigInt rows[2];
        mfem::HypreParMatrix matrix;
        mfem::HypreILU ilu;
        mfem::Vector r, z;
        explicit Factor(const Matrix& A)
            : values(A),
              sparse(values.outerIndexPtr(), values.innerIndexPtr(), values.valuePtr(), static_cast<int>(A.rows()),
                     static_cast<int>(A.cols()), false, false, true),
              rows{0, static_cast<HYPRE_BigInt>(A.rows())},
              matrix(MPI_COMM_SELF, rows[1], rows, &sparse),
              r(static_cast<int>(A.rows())),
              z(static_cast<int>(A.rows())) {}
    };
    const auto factor = std::make_shared<Factor>(A);
    factor->ilu.SetType(0);
    factor->ilu.SetLevelOfFill(0);
    factor->ilu.SetMaxIter(1);
    factor->ilu.SetTol(0);
    factor->ilu.SetLocalReordering(reorder ? 1 : 0);
    factor->ilu.SetPrintLevel(0);
    factor->ilu.SetOperator(factor->matrix);
    const Preconditioner apply = [factor](const Vector& r, Vector& z) {
        std::copy(r.begin(), r.end(), factor->r.begin());
        factor->z = 0.0;
        factor->ilu.Mult(factor->r, factor->z);
        z = Eigen::Map<const Vector>(factor->z.GetData(), z.size());
    };
    Vector z(A.rows());
    apply(Vector::Ones(A.rows()), z);  // hypre factorises at the first application
    return apply;
}

/// Returns Eigen's factor, which keeps the largest entries of each column, as many as the matrix has.
Preconditioner incomplete_cholesky(const Matrix& A) {
    using Factor = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>;
    const auto factor = std::make_shared<Factor>(Eigen::SparseMatrix<double>(A));
    return [factor](const Vector& r, Vector& z) { z = factor->solve(r); };
}

struct Stop {
    int iterations = 0;  ///< 0 when it was not reached
    double seconds = 0, residual = 0, displacement = 0;
};
struct Solve {
    Stop update;    ///< the paper's: an update of 1e-6 of the iterate
    Stop residual;  ///< a true relative residual of 1e-8
    bool indefinite = false;
};

Solve conjugate_gradients(const System& system, const Preconditioner& precondition) {
    constexpr double smallest_update = 1e-6, smallest_residual = 1e-8;
    constexpr int most = 3000;
    const auto& [A, b, observed] = system;
    Vector x = Vector::Zero(b.size()), r = b, z(b.size()), d, q;
    double rz = 0;
    Solve result;
    const double start = processor_seconds();
    const auto stop = [&](int iteration) {
        return Stop{iteration, processor_seconds() - start, (b - A * x).norm() / b.norm(), x[observed]};
    };
    for (int iteration = 1; iteration <= most && result.residual.iterations == 0; ++iteration) {
        precondition(r, z);
        const double rz_new = r.dot(z);
        if (rz == 0)
            d = z;
        else
            d = z + rz_new / rz * d;
        rz = rz_new;
        q.noalias() = A * d;
        const double curvature = d.dot(q);
        if (!(curvature > 0 && rz > 0)) {
            result.indefinite = true;
            break;
        }
        const double alpha = rz / curvature;
        x += alpha * d;
        r -= alpha * q;
        if (result.update.iterations == 0 && alpha * d.norm() <= smallest_update * x.norm())
            result.update = stop(iteration);
        if (r.norm() <= smallest_residual * b.norm()) result.residual = stop(iteration);
    }
    return result;
}

IcSpec spec_of(const Options& options) {
    const std::optional<FemSpec> preset = fem_preset(options.at("--preset"));
    if (!preset) throw InvalidArgument("--preset", "is '" + options.at("--preset") + "', which is not a preset");
    IcSpec spec;
    spec.source = IcSource::fem;
    spec.material = {.G = 1, .nu = 0.28};
    spec.dx = spec.dy = 1;
    spec.nx = spec.ny = 1;
    spec.fem = *preset;
    spec.fem.L_over_h = std::atof(options.at("--L_over_h").c_str());
    spec.fem.h_over_hs = std::atof(options.at("--h_over_hs").c_str());
    spec.fem.order = std::atoi(options.at("--order").c_str());
    return spec;
}

void print(const ElasticityProblem& problem, const System& system, const Solve& solve, double setup, double exact) {
    const auto stop = [&](const Stop& at) {
        char text[200];
        std::snprintf(text, sizeof text,
                      "{\"iterations\": %d, \"seconds\": %.4g, \"residual\": %.3e, \"origin_error\": %.6e}",
                      at.iterations, at.seconds, at.residual, at.displacement / exact - 1);
        return std::string(text);
    };
    std::printf(
        "{\"elements\": %lld, \"dofs\": %lld, \"unknowns\": %lld, \"nonzeros\": %lld, \"indefinite\": %s, "
        "\"setup_seconds\": %.4g, \"update\": %s, \"residual\": %s}\n",
        problem.elements(), problem.dofs(), static_cast<long long>(system.A.rows()),
        static_cast<long long>(system.A.nonZeros()), solve.indefinite ? "true" : "false", setup,
        stop(solve.update).c_str(), stop(solve.residual).c_str());
}

int run(const Options& options) {
    const IcSpec spec = spec_of(options);
    if (const std::string& file = options.at("--mesh"); !file.empty()) {
        std::ofstream out(file);
        out.precision(17);
        make_block_mesh(spec).mesh.Print(out);
        return out ? 0 : 1;
    }
    const Axis load = options.at("--load") == "x" ? Axis::x : options.at("--load") == "y" ? Axis::y : Axis::z;
    const std::string& numbering = options.at("--numbering");
    ElasticityProblem problem(MPI_COMM_SELF, spec);
    const Stiffness stiffness = options.at("--condensed") == "1" ? condensed(problem) : whole(problem);
    const System system = free_system(problem, stiffness, load, numbering);
    const double start = processor_seconds();
    const Preconditioner preconditioner =
        options.at("--preconditioner") == "ic" ? incomplete_cholesky(system.A) : ilu0(system.A, numbering == "rcm");
    const double setup = processor_seconds() - start;
    const Solve solve = conjugate_gradients(system, preconditioner);
    print(problem, system, solve, setup, half_space_coefficient(load, load, 0, 0, 1, 1, spec.material));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const Runtime runtime(argc, argv);
    Options options{{"--preset", "paper-test3"},
                    {"--L_over_h", "1280"},
                    {"--h_over_hs", "4"},
                    {"--order", "2"},
                    {"--load", "z"},
                    {"--preconditioner", "ilu0"},
                    {"--numbering", "outward"},
                    {"--condensed", "0"},
                    {"--mesh", ""}};
    for (int i = 1; i < argc; i += 2) {
        const auto option = options.find(argv[i]);
        if (option == options.end() || i + 1 == argc) {
            std::fprintf(stderr, "block_system: '%s' is not an option, or lacks its value\n", argv[i]);
            return 2;
        }
        option->second = argv[i + 1];
    }
    try {
        return run(options);
    } catch (const InvalidArgument& error) {
        std::fprintf(stderr, "block_system: %s\n", error.what());
        return 2;
    }
}

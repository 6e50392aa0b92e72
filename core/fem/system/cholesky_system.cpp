#include "cholesky_system.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>
#include <algorithm>
#include <new>

#include "condensed_assembly.hpp"
#include "contactd/error.hpp"

namespace contactd::fem {
namespace {

using Vector = Eigen::VectorXd;
using Factor = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

/// Limits the refinement steps after a factorisation; rounding usually makes a second one useless.
constexpr int refinements = 3;

/// Eigen reports success even if CHOLMOD had too little memory for a factorisation.
void require_memory(Factor& factor) {
    if (factor.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

/// Ordering and symbolic factorisation.
constexpr double analysis_seconds_per_dof = 2e-5;

/// Measures the rate of a product of dense matrices (floating-point operations per second).
double product_rate() {
    constexpr int n = 256;
    const Eigen::MatrixXd a = Eigen::MatrixXd::Ones(n, n);
    Eigen::MatrixXd b = a;
    b.noalias() = a * a;  // The first product makes BLAS allocate its buffers.
    const double start = MPI_Wtime();
    b.noalias() += a * a;
    return 2.0 * n * n * n / std::max(seconds_since(start), 1e-6);
}

}  // namespace

CholeskySystem::CholeskySystem(ElasticityProblem& problem, const AssemblyMonitor& monitor)
    : tolerance_(problem.spec().fem.tolerance) {
    if (problem.processes() > 1)
        throw InvalidArgument("ics.solver", "is direct, which requires a single process; use amg_pcg or auto");
    CondensedAssembly assembly(problem.space());
    lower_ = assembly.assemble(problem.spec().material, monitor);
    number_ = assembly.node_numbers();
}

CholeskySystem::Matrix CholeskySystem::free_part(const std::vector<int>& free_number, Eigen::Index count) const {
    Matrix result(count, count);
    result.reserve(lower_.nonZeros());
    for (Eigen::Index column = 0; column < lower_.cols(); ++column) {
        const int at = free_number[static_cast<std::size_t>(column)];
        if (at < 0) continue;
        result.startVec(at);
        for (Matrix::InnerIterator entry(lower_, column); entry; ++entry)
            if (const int row = free_number[static_cast<std::size_t>(entry.row())]; row >= 0)
                result.insertBack(row, at) = entry.value();
    }
    result.finalize();
    return result;
}

/// Returns the rate of the previous factorisation. The first value is half the rate of products, which factorisations
/// usually reach.
double CholeskySystem::factorisation_rate() {
    constexpr double efficiency = 0.5;
    if (rate_ == 0) rate_ = efficiency * product_rate();
    return rate_;
}

SolveResult CholeskySystem::solve(const LoadCase& load_case, mfem::Vector& u, const SolveMonitor& monitor) {
    double start = MPI_Wtime();
    Vector given = Vector::Zero(lower_.cols()), b = Vector::Zero(lower_.cols());
    std::vector<char> is_essential(static_cast<std::size_t>(load_case.given.Size()), 0);
    for (const int dof : load_case.essential) is_essential[static_cast<std::size_t>(dof)] = 1;
    std::vector<int> free_number(static_cast<std::size_t>(lower_.cols()), -1), free_dofs;
    const auto nodes = static_cast<int>(number_.size());
    for (int node = 0; node < nodes; ++node) {
        const int at = number_[static_cast<std::size_t>(node)];
        if (at < 0) continue;
        for (int i = 0; i < 3; ++i) {
            const int dof = 3 * node + i, row = 3 * at + i;
            given[row] = load_case.given[dof];
            b[row] = load_case.forces[dof];
            if (!is_essential[static_cast<std::size_t>(dof)]) free_number[static_cast<std::size_t>(row)] = 0;
        }
    }
    int count = 0;
    for (int& number : free_number)
        if (number == 0) number = count++;
    b -= lower_.selfadjointView<Eigen::Lower>() * given;

    const Matrix A = free_part(free_number, count);
    Vector right(count);
    for (std::size_t row = 0; row < free_number.size(); ++row)
        if (free_number[row] >= 0) right[free_number[row]] = b[static_cast<Eigen::Index>(row)];
    monitor.setup(analysis_seconds_per_dof * static_cast<double>(count), std::nullopt);
    Factor factor;
    factor.analyzePattern(A);
    require_memory(factor);
    const double operations = factor.cholmod().fl, begin = MPI_Wtime();
    const double expected = operations / factorisation_rate();
    monitor.setup(expected, expected);
    factor.factorize(A);
    require_memory(factor);
    rate_ = operations / std::max(seconds_since(begin), 1e-6);
    if (factor.info() != Eigen::Success)
        throw NotConverged("The stiffness matrix could not be factorised: it is not positive definite to rounding.");
    SolveResult result;
    result.setup_seconds = seconds_since(start);

    start = MPI_Wtime();
    Vector w = Vector::Zero(count), residual = right;
    for (int step = 0; step <= refinements; ++step) {
        w += factor.solve(residual);
        residual = right - A.selfadjointView<Eigen::Lower>() * w;
        result.residual = residual.norm() / right.norm();
        monitor.iteration(step, result.residual, 0);
        if (result.residual <= tolerance_) break;
    }
    result.converged = result.residual <= tolerance_;
    u = load_case.given;
    for (int node = 0; node < nodes; ++node)
        for (int i = 0; i < 3; ++i)
            if (const int at = number_[static_cast<std::size_t>(node)]; at >= 0)
                if (const int free = free_number[static_cast<std::size_t>(3 * at + i)]; free >= 0)
                    u[3 * node + i] += w[free];
    result.solve_seconds = seconds_since(start);
    return result;
}

}  // namespace contactd::fem

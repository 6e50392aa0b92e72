// Tests that the coefficients of a section are positive, as solvers require.
#include <Eigen/Eigenvalues>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

#include "bodies/strip_influence.hpp"
#include "geometry/section/section_geometry.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/spectrum_build.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

constexpr double nu = 0.28;
constexpr int strips = 8;

SectionOutline outline_of_section(const Section& section) {
    return outline_of(geometry::SectionGeometry(section, strips, 1, "ics.section"));
}

/// Lists sections: near an edge, in a groove, on a round end, and a rail that is clamped at its foot.
std::vector<SectionOutline> outlines() {
    return {edge_block(50, 30, 0.5, strips), groove(6, 20, 20, strips), round_end(4, 20, strips),
            outline_of_section({RailSection{0, RailSupport::foot, 20}})};
}

/// Returns the smallest eigenvalue of a symmetric matrix over the largest one.
double least_eigenvalue(const Eigen::MatrixXd& matrix) {
    REQUIRE((matrix - matrix.transpose()).norm() <= 1e-10 * matrix.norm());
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
    return values.minCoeff() / values.maxCoeff();
}

Eigen::MatrixXd matrix_at(const StripSpectrum& spectrum, std::size_t node) {
    const int n = 3 * spectrum.strips;
    Eigen::MatrixXd matrix(n, n);
    for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) matrix(a, b) = spectrum.values[spectrum.index(node, a, b)];
    return matrix;
}

/// Assembles the matrix by products with one traction after the other.
Eigen::MatrixXd matrix_of(const InfluenceOperator& influence) {
    const auto n = static_cast<Eigen::Index>(influence.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    std::vector<double> p(influence.size(), 0), none(influence.size(), 0), x(influence.size()), y(x), z(x);
    const auto store = [&](Eigen::Index strip) {
        for (Eigen::Index i = 0; i < n; ++i) {
            matrix(i, strip) = x[static_cast<std::size_t>(i)];
            matrix(n + i, strip) = y[static_cast<std::size_t>(i)];
            matrix(2 * n + i, strip) = z[static_cast<std::size_t>(i)];
        }
    };
    for (Eigen::Index i = 0; i < n; ++i) {
        p[static_cast<std::size_t>(i)] = 1;
        influence.tangential(p, none, x, y);
        influence.normal_of_tangential(p, none, z);
        store(i);
        influence.tangential(none, p, x, y);
        influence.normal_of_tangential(none, p, z);
        store(n + i);
        influence.tangential_of_normal(p, x, y);
        influence.normal(p, z);
        store(2 * n + i);
        p[static_cast<std::size_t>(i)] = 0;
    }
    return matrix;
}

}  // namespace

TEST_CASE("Coefficients of sections are positive at every wavenumber and as solvers use them", "[section]") {
    for (const SectionOutline& outline : outlines()) {
        Observer observer;
        const StripSpectrum spectrum = build_spectrum(MPI_COMM_SELF, outline, nu, 1e-2, observer).spectrum;
        for (std::size_t node = 0; node < spectrum.nodes.size(); ++node) {
            CAPTURE(spectrum.nodes[node]);
            CHECK(least_eigenvalue(matrix_at(spectrum, node)) > 1e-6);
        }
        ContactProblem problem;
        problem.grid = Grid::of_elements(9, strips, 1, 1);
        problem.bodies = {{Material::rigid()}, {Material{1, nu}}};
        const ContactInfluence influence = strip_influence(problem, strip_table(spectrum, 1, problem.grid.nx));
        CHECK(least_eigenvalue(matrix_of(*influence.current)) > 1e-6);
    }
}

// Compares a cylinder in a hole of nearly its own radius, both by finite elements, with Persson's closed form.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/curved_cases.hpp"
#include "geometry/section/section_geometry.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/section_model.hpp"
#include "section/spectrum/spectrum_build.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

constexpr double nu = 0.28, degree = pi / 180, radius = 1 / degree;  // strips of one degree, lengths over their width
constexpr int strips = 168;

/// Evaluates Persson's solution for identical cylinders under the force Q per length, in contact over +-half_angle (A.
/// Persson, On the stress distribution of cylindrical elastic bodies in contact, 1964): E'(R2 - R1)/Q with E' = 2 G/(1
/// - nu), and pressures.
class Persson {
   public:
    explicit Persson(double half_angle) : b_(std::tan(half_angle / 2)), b2_(b_ * b_) {}
    double clearance() const { return (2 - std::log(1 + b2_) - 2 * b2_ * b2_) / (pi * b2_ * (1 + b2_)); }
    /// p R/Q
    double pressure(double angle) const {
        const double y = std::tan(angle / 2);
        if (std::abs(y) >= b_) return 0;
        const double s = std::sqrt(b2_ - y * y), q = std::sqrt(1 + b2_);
        return 2 * s / (pi * q * (1 + y * y)) + std::log((q + s) / (q - s)) / (2 * pi * b2_ * (1 + b2_));
    }

   private:
    double b_, b2_;
};

/// Sums long strips of a section of unit material, which are in plane strain.
struct PlaneSection {
    StripTable table{1, strips};
    std::vector<StripFrame> frames;

    explicit PlaneSection(const Section& section) {
        const SectionOutline outline = outline_of(geometry::SectionGeometry(section, strips, 1, "section"));
        MeshDensity density;
        density.edges_a_strip = 2;
        const DividedOutline divided = divide(outline, density);
        const SectionMesh mesh = make_section_mesh(outline, divided, triangulate(divided, density), 4);
        const WaveResponse response = SectionModel(outline, mesh, 4, nu).at(0);
        frames = strip_frames(outline);
        for (const Axis i : {Axis::x, Axis::y, Axis::z})
            for (const Axis j : {Axis::x, Axis::y, Axis::z})
                for (int I = 0; I < strips; ++I)
                    for (int J = 0; J < strips; ++J) {
                        const std::size_t a = 3 * I + static_cast<int>(i), b = 3 * J + static_cast<int>(j),
                                          high = std::max(a, b), low = std::min(a, b);
                        table(i, j, I, J, 0) = response.values[high * (high + 1) / 2 + low];
                    }
    }
};

/// Finds the end of the pressure, where its square decreases linearly.
double half_angle_of(const ContactSolution& solution, const std::vector<StripFrame>& frames) {
    std::size_t last = frames.size() - 1;
    while (solution.pressure[last] == 0) --last;
    // Excludes the last strip, which the contact may cover only in part.
    const double outer = solution.pressure[last - 1], inner = solution.pressure[last - 3];
    const double slope = (inner * inner - outer * outer) / (frames[last - 1].angle - frames[last - 3].angle);
    return std::abs(frames[last - 1].angle + outer * outer / slope);
}

}  // namespace

TEST_CASE("A cylinder in a hole of nearly its radius is pressed as Persson says", "[section][curved]") {
    const PlaneSection disc({Disc{radius, 0.005 * radius}}), hole({PlateHole{radius, 50 * radius}});
    const StripTable pair = pair_of(disc.table, hole.table);
    for (const double half_angle : {20, 30, 45, 60, 75, 80}) {
        const Persson persson(half_angle * degree);
        const double force = 1, modulus = 2 / (1 - nu);
        ContactProblem problem;
        problem.grid = Grid::of_elements(1, strips, 1, 1);
        problem.bodies = {{Material{1, nu}}, {Material{1, nu}}};
        problem.columns = ContactColumns{hole.frames, 0, {}};
        std::vector<double> gap;
        for (const StripFrame& frame : hole.frames)
            gap.push_back(persson.clearance() * force / modulus * (1 - std::cos(frame.angle)));
        problem.gap = gap;
        problem.Fn = force;
        const ContactSolution solution = test::solve_strips(problem, pair);
        CAPTURE(half_angle);
        REQUIRE(solution.converged());
        const double largest = persson.pressure(0) / radius;
        CHECK_THAT(solution.pmax, WithinRel(largest, 5e-3));
        CHECK_THAT(half_angle_of(solution, hole.frames) / degree, WithinRel(half_angle, 1e-2));
        for (int strip = 0; strip < strips; ++strip) {
            const double angle = hole.frames[static_cast<std::size_t>(strip)].angle;
            if (std::abs(std::abs(angle) / degree - half_angle) > 1.5)  // deviation of a strip that is half in contact
                CHECK_THAT(solution.pressure[static_cast<std::size_t>(strip)],
                           WithinAbs(persson.pressure(angle) / radius, 1e-2 * largest));
        }
    }
}

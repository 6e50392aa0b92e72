// Solves the Cattaneo problem of the paper (section 4): a sphere pressed on a plane and shifted, with partial slip.
//
//     contactd-cpp-example ENDPOINT
#include <cstdio>
#include <exception>

#include "contactd/client/client.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s ENDPOINT, e.g. ipc:///run/contactd.sock\n", argv[0]);
        return 2;
    }
    try {
        contactd::ContactProblem problem;
        problem.grid = contactd::Grid::of_elements(40, 40, 0.06, 0.06);  // mm
        problem.bodies = {{200, 0.42}, {200, 0.42}};                     // G (N/mm^2), nu
        problem.gap = contactd::Paraboloid{50, 50};                      // radii (mm)
        problem.approach = 0.02;                                         // mm; or problem.Fn, a force (N)
        contactd::Shift shift;
        shift.rigid_shift.x = 0.00817;  // mm
        problem.friction = contactd::FrictionLaw{{0.4}};
        problem.motion = shift;

        contactd::client::Client client(argv[1]);
        const auto reply = client.solve(problem);

        const auto& solution = reply.solution;
        std::printf("Fn     %.8g N\nFx     %.8g N\npmax   %.8g N/mm^2\n", solution.forces.Fn, solution.forces.Fx,
                    solution.pmax);
        std::printf("area   %.5g mm^2, %d elements in adhesion, %d in slip\n", solution.area.contact,
                    solution.elements.adhesion, solution.elements.slip);
        std::printf("normal: %d iterations, residual %.1e; tangential: %d iterations, residual %.1e\n",
                    solution.evidence.normal.iterations, solution.evidence.normal.residual,
                    solution.evidence.tangential->iterations, solution.evidence.tangential->residual);
        std::printf("coefficients: %s\n", reply.ics.upper->evidence.version.c_str());
        return solution.converged() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

// Holds cases of an input file of the CONTACT program after a run: forces, patches and arrays by CONTACT's names.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contactd/by_name.hpp"
#include "contactd/contact.hpp"
#include "contactd/solve_reply.hpp"
#include "contactd/subsurface_stress.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Holds a file that cases name: a profile, a list of slices, or influence coefficients.
struct NamedFile {
    std::string name;       ///< name in the cases, with '/' between folders; profiles of a list of slices lie beside it
    std::string text{};     ///< its content
    std::string failure{};  ///< the reason if it could not be read, for the sentence of the cases that need it
};

/// Holds an input file with the files that it names.
struct ContactFileInput {
    std::string text;
    std::string name = "text";  ///< for messages
    std::vector<NamedFile> files{};
    std::vector<std::size_t> cases{};  ///< indices of the requested cases, from 0, in ascending order; empty: all
    WheelSurfaceKind wheel_surface = WheelSurfaceKind::exact;
    /// Largest number of elements of a case of module 3, which is refused beyond it, and of a patch of module 1 in
    /// steady rolling, which has larger elements beyond it. The blocks of a case have at most ten times as many points,
    /// and 1,000,000.
    std::size_t max_elements = 40'000;
};

/// Names the outcome of a case. read: not to be computed (R = 2, 3), or valid if nothing is to be solved. refused: it
/// requires something that contactd does not support, or numbers that it does not accept. failed: the solve ended with
/// an error. follows: it continues a case that was not computed. wrong: the case, or a file that it names, has an
/// error.
enum class ContactFileStatus { solved, not_converged, read, refused, failed, follows, wrong };

/// Holds stresses and displacements at a block of subsurface points, shape [nz, ny, nx]; z >= 0 in body 1.
struct ContactFileBlock {
    StressBlock points;                   ///< (mm)
    SubsurfaceDisplacement displacement;  ///< (mm)
    SubsurfaceStress stress;              ///< (N/mm^2)
};

/// Holds a contact of a case. Forces act on body 1.
struct ContactFilePatch {
    Grid grid;
    /// By CONTACT's names: those of its .out files, and SPINXO, SPINYO. On rails also YCP(R), ZCP(R), XCP(W), YCP(W)
    /// and ZCP(W), the reference in the axes of the profiles. Units are CONTACT's: mm, N, rad, J, W.
    ByName<double> numbers;
    std::vector<double> mu;     ///< coefficients at rest: one, or one for each row of a curved contact
    double friction_bound = 0;  ///< coefficient at rest times Fn (N)
    /// Contains arrays of shape [ny, nx] by CONTACT's names: IGS (0 exterior, 1 adhesion, 2 slip, 3 plastic), H, MU,
    /// PN, PX, PY, UX, UY, ...
    ByName<std::vector<double>> arrays;
    std::vector<ContactFileBlock> blocks;
    /// Numbers, from 1, of the patches of the last step that share rows of elements with this one. Absent if the step
    /// does not continue another one.
    std::optional<std::vector<int>> previous{};
};

struct ContactFileOutcome {
    int number = 0;        ///< as printed by CONTACT
    std::size_t line = 0;  ///< line of its first control word
    int module_number = 0;
    std::optional<int> reid{}, cpid{};
    ContactFileStatus status = ContactFileStatus::solved;
    std::string sentence;               ///< the reason if there are no results, or their limitation
    std::vector<std::string> warnings;  ///< of the solution
    double seconds = 0;                 ///< of the solve
    /// Contains forces of the whole case: for module 3 those of its contact, for module 1 FX(TR), FY(TR), FZ(TR),
    /// FX(WS), FY(WS), FZ(WS), and Z_WS and VPITCH_WS if they were searched for.
    ByName<double> numbers;
    std::variant<std::monostate, SolveReply, WheelRailSolution> solution;
    std::vector<ContactFilePatch> patches;  ///< for module 1, from the field side to the gauge side

    bool is_solved() const { return solution.index() != 0; }
};

/// Holds a wheel on its rail as in wheelrail.solve.
struct WheelRailProblem {
    WheelRailSetup setup;
    WheelRailState state;
};

/// Holds a case as a problem of contactd. Without one, the outcome contains the reason.
struct ContactFileProblem {
    ContactFileOutcome outcome;
    bool continues = false;  ///< whether the case starts from the end of an earlier one, which the problem lacks
    std::variant<std::monostate, ContactProblem, WheelRailProblem> problem;
};

}  // namespace contactd

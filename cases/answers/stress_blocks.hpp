// Blocks of points inside the bodies, and the stresses there.
#pragma once

#include <vector>

#include "answers/solved.hpp"
#include "contactd/read_contact_file.hpp"
#include "contactd/subsurface_stress.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Points of a block for stresses: x and y are those of all element centres (kinds 1, 5), of elements first, step, last
/// (2, 6) or listed (3, 7), by numbers from 1 on, or coordinates (9, mm); z has coordinates (mm).
struct GivenBlock {
    int kind = 0;
    std::vector<double> x, y, z;

    bool operator==(const GivenBlock&) const = default;
};

/// Stresses in a block, as they are read: z > 0 inside the upper body.
struct SolvedBlock {
    GivenBlock given;
    StressBlock points;  ///< (mm), z as the caller has it
    SubsurfaceStress stress;
    SubsurfaceDisplacement displacement;  ///< (mm)
};

/// Kinds whose elements are all, or by first, step and last.
inline bool all_centres(int kind) {
    return kind == 1 || kind == 5;
}
inline bool range_of_elements(int kind) {
    return kind == 2 || kind == 6;
}

/// The blocks of a case of an input file. Throws NotCovered.
std::vector<GivenBlock> blocks_of(const ContactCase& read);

/// Its points, z > 0 inside the upper body (mm).
StressBlock block_points(const GivenBlock& block, const Grid& grid);

/// Stresses in the frame of the contact. At z = 0 they are those of the upper body.
SolvedBlock solve_block(const GivenBlock& block, const Solved& solved);

/// One column of the answer, a value for each point, x fastest: 1 to 3 x, y, z; 4 to 6 displacements; 7 to 9 the mean
/// of the normal stresses, von Mises' and Tresca's stress; 10 to 12 principal stresses, largest first; 13 to 21 xx, yx,
/// zx, xy, ... zz. Throws NotCovered for others.
std::vector<double> block_column(const SolvedBlock& block, int column, const Units& units);

}  // namespace contactd::cases

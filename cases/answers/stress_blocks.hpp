// Computes blocks of points inside the bodies, and their stresses.
#pragma once

#include <vector>

#include "answers/solved.hpp"
#include "contactd/observer.hpp"
#include "contactd/read_contact_file.hpp"
#include "contactd/subsurface_stress.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Points of a block for stresses. x and y are those of all element centres (kinds 1, 5), the numbers of elements from
/// 1 on as first, step, last (2, 6) or as a list (3, 7), or coordinates (9, mm). z has coordinates (mm).
struct GivenBlock {
    int kind = 0;
    std::vector<double> x, y, z;

    bool operator==(const GivenBlock&) const = default;
};

/// Holds stresses in a block, with z > 0 inside the upper body.
struct SolvedBlock {
    GivenBlock given;
    StressBlock points;  ///< (mm), with z as given
    SubsurfaceStress stress;
    SubsurfaceDisplacement displacement;  ///< (mm)
};

/// Returns whether a kind has all element centres.
inline bool all_centres(int kind) {
    return kind == 1 || kind == 5;
}
/// Returns whether a kind has elements by first, step and last.
inline bool range_of_elements(int kind) {
    return kind == 2 || kind == 6;
}

/// Returns the blocks of a case of an input file.
std::vector<GivenBlock> blocks_of(const ContactCase& read);

/// Returns the points of a block (mm), with z > 0 inside the upper body. Throws NotCovered for unknown elements.
StressBlock block_points(const GivenBlock& block, const Grid& grid);

/// Computes stresses in the frame of the contact. At z = 0 they are those of the upper body. Throws NotCovered,
/// and Cancelled.
SolvedBlock solve_block(const GivenBlock& block, const Solved& solved, Observer& observer);

/// Returns one column of the result, with a value for each point and x fastest. Columns 1 to 3: x, y, z; 4 to 6:
/// displacements; 7 to 9: mean normal stress, von Mises' and Tresca's stress; 10 to 12: principal stresses, largest
/// first; 13 to 21: xx, yx, zx, xy, ... zz. Throws NotCovered for other columns.
std::vector<double> block_column(const SolvedBlock& block, int column, const Units& units);

}  // namespace contactd::cases

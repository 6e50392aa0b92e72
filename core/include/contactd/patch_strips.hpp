// Strips on which the elements of a contact lie that is curved across the track: what its operators are made of.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact_columns.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Neighbouring strips of a body's surface, out of a table of more of them. Tables begin and end at multiples of many
/// strips along the profile, so that neighbouring positions of a wheel ask for the same ones.
struct BodyStrips {
    IcSpec spec{};  ///< of all strips of the table, of source fem; nx is that of the patch
    int first = 0;  ///< the patch's first one, as the section numbers them
};

struct PatchStrips {
    /// Frames of the rows of the grid, in the axes of the wheel, which is the lower body; shape [ny]. None: elements
    /// lie flat side by side.
    std::vector<StripFrame> frames{};
    /// Strips of bodies that are known by their sections: both, but for rigid ones.
    std::optional<BodyStrips> rail{}, wheel{};
    /// Half-spaces lie along the loaded row and only displacements turn; else midway between both rows, and loads turn
    /// as much.
    bool along_loaded_row = false;

    bool flat() const { return frames.empty(); }
    bool of_sections() const { return rail || wheel; }
};

/// The rows of a curved contact as strips of the wheel's surface: with the track's x, y and z in the place of the
/// section's, whose angles run the other way, the direction that of the reference's normal, and the origin there.
ContactColumns strips_of(const ContactPlace& place);

}  // namespace contactd

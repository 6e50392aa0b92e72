// Strips of elements of a contact that is curved across the track, from which its operators are created.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact_columns.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Neighbouring strips of a body's surface in a larger table. Tables begin and end at multiples of many strips along
/// the profile, so that nearby positions of a wheel use the same ones.
struct BodyStrips {
    IcSpec spec{};  ///< of all strips of the table, of source fem; nx is that of the patch
    int first = 0;  ///< first strip of the patch, in the numbering of the section
};

struct PatchStrips {
    /// Frames of the rows of the grid, in the axes of the wheel, which is the lower body; shape [ny]. None: a
    /// plane.
    std::vector<StripFrame> frames{};
    /// Strips of bodies given by their sections: of both bodies, except rigid ones.
    std::optional<BodyStrips> rail{}, wheel{};
    /// Half-spaces are along the loaded row, and only displacements are rotated; otherwise midway between both rows,
    /// and loads are rotated as much.
    bool along_loaded_row = false;

    bool flat() const { return frames.empty(); }
    bool of_sections() const { return rail || wheel; }
};

/// The rows of a curved contact as strips of the wheel's surface: with the track's x, y and z in the place of the
/// section's, whose angles run the other way, the direction that of the reference's normal, and the origin there.
ContactColumns strips_of(const ContactPlace& place);

}  // namespace contactd

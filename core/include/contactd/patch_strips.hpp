// Describes the strips of elements of a contact that is curved across the track, from which its operators are created.
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact_columns.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

/// Selects neighbouring strips of a body's surface in a larger table. Tables begin and end at multiples of many strips
/// along the profile, so that nearby positions of a wheel use the same ones.
struct BodyStrips {
    IcSpec spec{};  ///< all strips of the table, of source fem; nx is that of the patch
    int first = 0;  ///< first strip of the patch, in the numbering of the section
};

struct PatchStrips {
    /// Holds the frames of the rows of the grid, in the axes of the wheel, which is the lower body; shape [ny]. It is
    /// empty for a plane.
    std::vector<StripFrame> frames{};
    /// Hold the strips of both bodies if these are given by their sections; rigid bodies have none.
    std::optional<BodyStrips> rail{}, wheel{};
    /// If set, half-spaces are along the loaded row, and only displacements are rotated. Otherwise half-spaces are
    /// midway between both rows, and loads are rotated by the same angle.
    bool along_loaded_row = false;

    bool flat() const { return frames.empty(); }
    bool of_sections() const { return rail || wheel; }
};

/// Returns the rows of a curved contact as strips of the wheel's surface. The track's x, y and z take the place of the
/// section's, whose angles have the opposite sign. The direction is that of the reference's normal, and the origin is
/// at the reference.
ContactColumns strips_of(const ContactPlace& place);

}  // namespace contactd

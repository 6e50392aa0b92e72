// Profiles from files of measuring instruments and of other programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "contactd/profile_spec.hpp"

namespace contactd {

/// The size that a file of profiles may have.
inline constexpr std::size_t most_profile_bytes = 16 << 20;

/// The points of a profile as its file has them, with the unit and the mirroring that the format means; make_profile
/// makes a curve of them. The ending of `name` says what `text` is:
///   .prr, .prw   rail and wheel of Simpack, whose shifts, rotation, bounds, mirroring and units are applied
///   .ban, .whl   rail and wheel of MiniProf, with heads of all years
///   others       two columns, y and z in mm, with blanks, tabs, commas or semicolons between them, decimal commas
///   where
///                these do not separate, headings, and comments behind #, % or !; `kind` says what they are
/// Which way z points is seen by the shape of the points where the file does not say it (all but Simpack's); where the
/// shape does not say it either, upwards in MiniProf's files, downwards in others.
/// Throws InvalidArgument, naming file and line, for what is none of this, for a `kind` that is not the file's, and for
/// files beyond the limits.
ProfileSpec read_profile(std::string_view text, const std::string& name, std::optional<ProfileKind> kind = {});
/// Reads a file on disk likewise. Throws InvalidArgument when it cannot be read.
ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind = {});

}  // namespace contactd

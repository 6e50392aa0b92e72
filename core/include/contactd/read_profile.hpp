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
///   .ban, .whl   rail and wheel of MiniProf, whose vertical axis points upwards
///   others       two columns, y and z in mm, with spaces, tabs, commas or semicolons between them and comments behind
///                #, % or !; `kind` says what they are
/// Throws InvalidArgument, naming file and line, for what is none of this, for a `kind` that is not the file's, and for
/// files beyond the limits.
ProfileSpec read_profile(std::string_view text, const std::string& name, std::optional<ProfileKind> kind = {});
/// Reads a file on disk likewise. Throws InvalidArgument when it cannot be read.
ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind = {});

}  // namespace contactd

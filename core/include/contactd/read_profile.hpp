// Reads profiles from files of measuring instruments and of other programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/profile_evidence.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// A profile file has at most this size in bytes.
inline constexpr std::size_t most_profile_bytes = 16 << 20;

/// Reads the points of a profile as the file contains them, with the unit and the mirroring that its format implies;
/// make_profile makes a curve from them. The extension of `name` selects the format of `text`:
///   .prr, .prw   rail and wheel of Simpack, whose shifts, rotation, bounds, mirroring and units are applied
///   .ban, .whl   rail and wheel of MiniProf, with the headers of all years
///   others       two columns, y and z in mm, separated by blanks, tabs, commas or semicolons. Decimal commas are
///                allowed if commas do not separate. Headings, and comments after #, % or !, are skipped. `kind`
///                selects wheel or rail.
/// Only Simpack's files state the direction of z. For the others, the shape of the points determines it. If the shape
/// is ambiguous, z points upwards in MiniProf's files and downwards in others. Throws InvalidArgument, which names file
/// and line, if the text has none of these formats, if `kind` is not that of the file, and for files beyond the limits.
ProfileSpec read_profile(std::string_view text, const std::string& name, std::optional<ProfileKind> kind = {});
/// Reads a file on disk in the same way. Throws InvalidArgument if it cannot be read.
ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind = {});
/// Returns the bytes of such a file.
std::string text_of_profile(const std::filesystem::path& file);

/// Holds the points of a file in mm, mirrored and shifted, and the evidence.
struct PointsOfFile {
    ProfilePoints points;
    ProfileReading reading;
    double rounded_to = 0;  ///< as in ProfileEvidence
    std::vector<std::string> warnings{};
};

/// Reads the points with the options of ProfileFile in addition to those in its text. Throws InvalidArgument with the
/// field "profile.file" for the errors of read_profile, and if the unit or the direction of z follows neither from the
/// text, nor from the shape, nor from the options.
PointsOfFile points_of(const ProfileFile& file, ProfileKind kind);

/// Returns the profile with a file replaced by its points; other profiles do not change.
ProfileSpec with_points(const ProfileSpec& profile);

/// Returns the problem in `error` for naming_file(): it names the file and the line, or "profile.points".
std::string problem_of_file(const ProfileFile& file, const InvalidArgument& error);

/// Returns the result of `work` on a file or its points. Errors name "profile.file" and the file.
template <class Work>
auto naming_file(const ProfileFile& file, const Work& work) {
    try {
        return work();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument("profile.file", problem_of_file(file, error));
    }
}

}  // namespace contactd

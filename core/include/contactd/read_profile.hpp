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

/// Largest size of a profile file.
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
/// Reads a file on disk in the same way. Throws InvalidArgument if it cannot be read.
ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind = {});
/// Returns the bytes of such a file.
std::string text_of_profile(const std::filesystem::path& file);

/// The points of a file in mm, mirrored and shifted, and the evidence.
struct PointsOfFile {
    ProfilePoints points;
    ProfileReading reading;
    double rounded_to = 0;  ///< as of ProfileEvidence
    std::vector<std::string> warnings{};
};

/// Reads the points with the options of ProfileFile in addition to those in its text. Throws InvalidArgument with the
/// field "profile.file" for the errors of read_profile, and if the unit or the direction of z follows neither from the
/// text, nor from the shape, nor from the options.
PointsOfFile points_of(const ProfileFile& file, ProfileKind kind);

/// Returns the profile with the points of its file in place of the file; others are unchanged.
ProfileSpec with_points(const ProfileSpec& profile);

/// For naming_file: returns the problem in `error`, which names the file and the line, or "profile.points".
std::string problem_of_file(const ProfileFile& file, const InvalidArgument& error);

/// Returns the result of `work` on a file or its points; errors name "profile.file" and the file.
template <class Work>
auto naming_file(const ProfileFile& file, const Work& work) {
    try {
        return work();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument("profile.file", problem_of_file(file, error));
    }
}

}  // namespace contactd

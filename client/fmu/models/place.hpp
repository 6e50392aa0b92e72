// Where files lie that importers and users name: by paths, by URIs, or by names in the FMU's resources.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace contactd::fmu {

/// Returns the path of a URI, file:///... with its %20, or a path as it is.
std::filesystem::path path_of(std::string_view name);

/// The file that `name` means: a URI, a path from the root on, or one from `resources` on; where there is none of this
/// name, without the spaces around it, and with \ as /. Nothing where there is no such file. Throws Failure for one
/// that leads out of `top`, once links are followed, without being a path from the root on: it is not for the FMU of a
/// stranger to say which files of its user are read.
std::optional<std::filesystem::path> file_named(const std::string& name, const std::filesystem::path& resources,
                                                const std::filesystem::path& top);
inline std::optional<std::filesystem::path> file_named(const std::string& name,
                                                       const std::filesystem::path& resources) {
    return file_named(name, resources, resources);
}

/// Returns whether the path lies in the folder or below it, once links are followed.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

/// In small letters and without spaces: s1002 of "S 1002".
std::string lowercase_name(std::string_view name);

}  // namespace contactd::fmu

// Finds files given by importers and users: by paths, by URIs, or by names in the FMU's resources.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace contactd::fmu {

/// Returns the path of a URI, file:///... with %20 decoded, or an unchanged path.
std::filesystem::path path_of(std::string_view name);

/// Returns the file `name`: a URI, an absolute path, or one relative to `resources`. If there is no file of this name,
/// spaces around it are removed, and \ is replaced by /. Returns none if there is no file. Throws Failure for a
/// relative path outside `top` after links are resolved: an untrusted FMU must not choose which files of its user are
/// read.
std::optional<std::filesystem::path> file_named(const std::string& name, const std::filesystem::path& resources,
                                                const std::filesystem::path& top);
inline std::optional<std::filesystem::path> file_named(const std::string& name,
                                                       const std::filesystem::path& resources) {
    return file_named(name, resources, resources);
}

/// Returns whether the path is in the folder or below it, after links are resolved.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Returns the text in lower case without spaces: s1002 for "S 1002".
std::string lowercase_name(std::string_view name);

}  // namespace contactd::fmu

// Provides the files that a case names: profiles, lists of slices, influence coefficients.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contactd/contact_file_run.hpp"

namespace contactd::cases {

class NamedFiles {
   public:
    virtual ~NamedFiles() = default;
    /// Returns the content of a file by its name in the case, with '/' between folders. Throws NotCovered
    /// (Subject::file) if there is none, or if it has more than `most` bytes.
    virtual std::string text(const std::string& name, std::uintmax_t most) const = 0;
};

/// Reads files on disk. Their names are relative to the folder.
class FilesInFolder : public NamedFiles {
   public:
    explicit FilesInFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
    std::string text(const std::string& name, std::uintmax_t most) const override;

   private:
    std::filesystem::path folder_;
};

/// Provides files whose contents came with the case.
class GivenFiles : public NamedFiles {
   public:
    explicit GivenFiles(std::vector<NamedFile> files);
    std::string text(const std::string& name, std::uintmax_t most) const override;

   private:
    std::map<std::string, NamedFile, std::less<>> files_;
};

/// Returns the name of a file with '/' between folders.
std::string with_slashes(std::string name);
/// Returns the name of a file that `from` names: it lies in the same folder.
std::string beside(const std::string& from, const std::string& name);

}  // namespace contactd::cases

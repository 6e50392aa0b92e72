#include "named_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw NotCovered(Subject::file, "The file \"" + name + "\" cannot be read: " + reason + ".");
}

[[noreturn]] void refuse_size(const std::string& name, std::uintmax_t bytes, std::uintmax_t most) {
    refuse(name, "it has " + std::to_string(bytes) + " bytes, but at most " + std::to_string(most) + " are read");
}

}  // namespace

std::string with_slashes(std::string name) {
    std::ranges::replace(name, '\\', '/');
    return name;
}

std::string beside(const std::string& from, const std::string& name) {
    return (std::filesystem::path(from).parent_path() / with_slashes(name)).generic_string();
}

std::string FilesInFolder::text(const std::string& name, std::uintmax_t most) const {
    const std::filesystem::path path = folder_ / name;
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
    if (failed) refuse(path.string(), failed.message());
    if (bytes > most) refuse_size(path.string(), bytes, most);
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) refuse(path.string(), "check its permissions");
    return text;
}

GivenFiles::GivenFiles(std::vector<NamedFile> files) {
    for (NamedFile& file : files) {
        std::string name = file.name;
        files_.emplace(std::move(name), std::move(file));
    }
}

std::string GivenFiles::text(const std::string& name, std::uintmax_t most) const {
    const auto found = files_.find(name);
    if (found == files_.end()) refuse(name, "its content was not given");
    const NamedFile& file = found->second;
    if (!file.failure.empty()) refuse(name, file.failure);
    if (file.text.size() > most) refuse_size(name, file.text.size(), most);
    return file.text;
}

}  // namespace contactd::cases

#include "place.hpp"

#include <algorithm>
#include <charconv>

#include "failure.hpp"

namespace contactd::fmu {
namespace {

constexpr std::string_view blanks = " \t\r\n";

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_uri(std::string_view name) {
    constexpr std::string_view scheme = "file:";
    return name.size() >= scheme.size() && std::ranges::equal(name.substr(0, scheme.size()), scheme, {}, small);
}

std::optional<std::filesystem::path> if_file(const std::filesystem::path& name, const std::filesystem::path& resources,
                                             const std::filesystem::path& top) {
    std::error_code failed;
    std::filesystem::path path = resources / name;
    if (!std::filesystem::is_regular_file(path, failed)) return std::nullopt;
    if (!name.is_absolute() && !lies_within(path, top))
        throw Failure("\"" + name.string() + "\" leads out of " + top.string() +
                      ". Put the file there, or name it by its whole path.");
    return path;
}

}  // namespace

std::filesystem::path path_of(std::string_view uri) {
    if (!is_uri(uri)) return uri;
    uri.remove_prefix(uri.find(':') + 1);
    if (uri.starts_with("//")) uri.remove_prefix(std::min(uri.size(), uri.find('/', 2)));  // with the machine's name
    std::string path;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        unsigned char letter = static_cast<unsigned char>(uri[at]);
        if (letter == '%' && at + 2 < uri.size() &&
            std::from_chars(uri.data() + at + 1, uri.data() + at + 3, letter, 16).ptr == uri.data() + at + 3)
            at += 2;
        path += static_cast<char>(letter);
    }
#ifdef _WIN32
    if (path.size() > 2 && path[0] == '/' && path[2] == ':') path.erase(0, 1);  // file:///C:/...
#endif
    return path;
}

bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder) {
    std::error_code failed;
    const std::filesystem::path top = std::filesystem::weakly_canonical(folder / "", failed),
                                place = std::filesystem::weakly_canonical(path, failed);
    if (failed) return false;
    const auto [end, other] = std::mismatch(top.begin(), top.end(), place.begin(), place.end());
    return end == top.end() || end->empty();
}

std::optional<std::filesystem::path> file_named(const std::string& name, const std::filesystem::path& resources,
                                                const std::filesystem::path& top) {
    if (name.empty()) return {};
    if (auto found = if_file(name, resources, top)) return found;
    std::string meant(trimmed(name));
    if (meant.empty()) return {};
    if (auto found = if_file(path_of(meant), resources, top)) return found;
    std::ranges::replace(meant, '\\', '/');
    return if_file(path_of(meant), resources, top);
}

std::string lowercase_name(std::string_view name) {
    std::string result;
    for (const char letter : name)
        if (blanks.find(letter) == std::string_view::npos) result += small(letter);
    return result;
}

}  // namespace contactd::fmu

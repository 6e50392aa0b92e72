#include "resources.hpp"

#include <charconv>
#include <string>

namespace contactd::fmu {

std::filesystem::path folder_of(std::string_view uri) {
    constexpr std::string_view scheme = "file:";
    if (!uri.starts_with(scheme)) return uri;
    uri.remove_prefix(scheme.size());
    if (uri.starts_with("//")) uri.remove_prefix(std::min(uri.size(), uri.find('/', 2)));  // with the machine's name
    std::string path;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        unsigned char letter = static_cast<unsigned char>(uri[at]);
        if (letter == '%' && at + 2 < uri.size() &&
            std::from_chars(uri.data() + at + 1, uri.data() + at + 3, letter, 16).ptr == uri.data() + at + 3)
            at += 2;
        path += static_cast<char>(letter);
    }
    return path;
}

}  // namespace contactd::fmu

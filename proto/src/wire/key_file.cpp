#include "contactd/proto/key_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "contactd/error.hpp"

namespace contactd::proto {
namespace {

constexpr std::size_t key_characters = 40;
constexpr std::uintmax_t largest_file = 64 << 10;
constexpr std::string_view z85 =
    "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#";

std::string_view stripped(std::string_view text, std::string_view of) {
    const std::size_t first = text.find_first_not_of(of);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(of) - first + 1);
}

std::string key_of(std::string_view field, std::string_view value) {
    value = stripped(value, " \t\r\"'");
    const bool known =
        std::all_of(value.begin(), value.end(), [](char c) { return z85.find(c) != std::string_view::npos; });
    if (value.size() != key_characters || !known)
        throw Error(std::string(field) +
                    " is not a key; it must be 40 characters of Z85, as written by contactd keygen.");
    return std::string(value);
}

std::filesystem::file_status status_of(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (error) throw Error("The key file " + path.string() + " cannot be read: " + error.message() + ".");
    return status;
}

}  // namespace

KeyFile parse_key_file(std::string_view text) {
    KeyFile keys;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = stripped(text.substr(0, end), " \t\r");
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t equals = line.find('=');
        if (line.starts_with('#') || equals == std::string_view::npos) continue;
        const std::string_view field = stripped(line.substr(0, equals), " \t");
        if (field == "public-key") keys.public_key = key_of(field, line.substr(equals + 1));
        if (field == "secret-key") keys.secret_key = key_of(field, line.substr(equals + 1));
    }
    if (keys.public_key.empty()) throw Error("It has no line public-key = \"...\".");
    return keys;
}

KeyFile read_key_file(const std::filesystem::path& path) {
    std::error_code no_size;
    if (!std::filesystem::is_regular_file(status_of(path)) || std::filesystem::file_size(path, no_size) > largest_file)
        throw Error("The key file " + path.string() + " is not a regular file of a few lines.");
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw Error("The key file " + path.string() + " cannot be read.");
    try {
        return parse_key_file(text);
    } catch (const Error& error) {
        throw Error("The key file " + path.string() + " cannot be used: " + error.what());
    }
}

void check_private(const std::filesystem::path& path) {
    using std::filesystem::perms;
    constexpr perms of_others = perms::group_all | perms::others_all;
    if ((status_of(path).permissions() & of_others) != perms::none)
        throw Error("The key file " + path.string() + " contains a secret that other users can read; run: chmod 600 " +
                    path.string());
}

}  // namespace contactd::proto

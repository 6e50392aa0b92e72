#include "curve_keys.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zmq.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "contactd/error.hpp"
#include "contactd/proto/key_file.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 64;
constexpr std::size_t z85_size = 41;  // 40 characters and a zero
constexpr std::size_t raw_size = 32;

/// Names occur in logs and paths, so only plain characters are allowed.
bool is_name(const std::string& name) {
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '@'; };
    return !name.empty() && name.size() <= longest_name && name[0] != '.' &&
           std::all_of(name.begin(), name.end(), plain);
}

std::string user_named_by(const fs::path& file) {
    const std::string name = file.stem().string();
    if (!is_name(name))
        throw Error("The key file " + proto::dump(file.string()) +
                    " does not have the name of a user, which has at most 64 characters: letters, digits and . _ - @.");
    return name;
}

void check_decodes(const std::string& key, const fs::path& file) {
    std::array<std::uint8_t, raw_size> raw{};
    if (!zmq_z85_decode(raw.data(), key.c_str()))
        throw Error("The key file " + file.string() + " contains characters that Z85 keys do not use.");
}

void write_new(const fs::path& path, const std::string& text, mode_t mode) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (fd < 0)
        throw Error("The key file " + path.string() + " cannot be created: " + std::strerror(errno) +
                    (errno == EEXIST ? ". Keys are never overwritten; choose another name, or move the file." : "."));
    const bool written = ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && ::fsync(fd) == 0;
    const int error = errno;
    ::close(fd);
    if (written) return;
    ::unlink(path.c_str());
    throw Error("The key file " + path.string() + " cannot be written: " + std::strerror(error) + ".");
}

std::string text_of(const std::string& comment, const std::string& name, const std::string& keys) {
    return "# " + comment + "\nmetadata\n    name = \"" + name + "\"\ncurve\n" + keys;
}

}  // namespace

std::string AllowedKeys::user_of(const std::string& public_key) const {
    const auto found = users_.find(public_key);
    return found == users_.end() ? std::string() : found->second;
}

bool AllowedKeys::has_user(const std::string& name) const {
    return std::any_of(users_.begin(), users_.end(), [&](const auto& entry) { return entry.second == name; });
}

AllowedKeys AllowedKeys::read(const fs::path& folder, std::vector<std::string>& problems) {
    AllowedKeys keys;
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".key") files.push_back(entry->path());
    if (error)
        throw Error("The folder of allowed keys " + folder.string() + " cannot be read: " + error.message() + ".");
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        try {
            const std::string user = user_named_by(file);
            const proto::KeyFile content = proto::read_key_file(file);
            if (!content.secret_key.empty())
                throw Error("The key file " + file.string() +
                            " contains a secret key, which only its user may have; replace it by the public file.");
            check_decodes(content.public_key, file);
            const auto [at, is_new] = keys.users_.emplace(content.public_key, user);
            if (!is_new)
                throw Error("The key file " + file.string() + " contains the key of the user " + at->second +
                            "; each user needs a separate key.");
        } catch (const std::exception& problem) {
            problems.emplace_back(problem.what());
        }
    }
    return keys;
}

std::string read_secret_key(const fs::path& path) {
    proto::KeyFile keys = proto::read_key_file(path);
    if (keys.secret_key.empty())
        throw Error("The key file " + path.string() + " contains no secret key; the daemon needs its NAME.key_secret.");
    proto::check_private(path);
    check_decodes(keys.secret_key, path);
    return keys.secret_key;
}

NewKeys generate_keys(const fs::path& folder, const std::string& name) {
    if (!is_name(name))
        throw Error("The name \"" + name + "\" is invalid; use at most 64 letters, digits and . _ - @.");
    std::array<char, z85_size> public_key{}, secret_key{};
    if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0)
        throw Error("The ZeroMQ library of this machine was built without CURVE.");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("The folder " + folder.string() + " cannot be created: " + error.message() + ".");
    const NewKeys files{folder / (name + ".key_secret"), folder / (name + ".key")};
    const std::string public_line = std::string("    public-key = \"") + public_key.data() + "\"\n";
    const std::string secret_line = std::string("    secret-key = \"") + secret_key.data() + "\"\n";
    write_new(files.secret_file,
              text_of("Secret key of " + name + ", created by contactd. Keep this file private.", name,
                      public_line + secret_line),
              0600);
    try {
        write_new(files.public_file,
                  text_of("Public key of " + name + ", created by contactd. It is not secret.", name, public_line),
                  0644);
    } catch (...) {
        ::unlink(files.secret_file.c_str());
        throw;
    }
    return files;
}

}  // namespace contactd::server

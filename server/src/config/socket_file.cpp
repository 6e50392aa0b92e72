#include "socket_file.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

namespace contactd::server {
namespace {

constexpr std::string_view ipc = "ipc://";

const char* kind_of(mode_t mode) {
    switch (mode & S_IFMT) {
        case S_IFREG:
            return "a file";
        case S_IFDIR:
            return "a folder";
        case S_IFLNK:
            return "a symbolic link";
        case S_IFIFO:
            return "a pipe";
        default:
            return "a device";
    }
}

/// Connects to the Unix socket `file`, and returns 0 or an error number.
int connecting_to(const std::string& file) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(file.begin(), file.end(), address.sun_path);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int error = ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
    ::close(fd);
    return error;
}

}  // namespace

std::string socket_file(const std::string& endpoint) {
    if (!endpoint.starts_with(ipc) || endpoint.starts_with("ipc://@") || endpoint == "ipc://*") return {};
    return endpoint.substr(ipc.size());
}

std::string socket_file_problem(const std::string& endpoint) {
    const std::string file = socket_file(endpoint);
    if (file.empty()) return {};
    const std::string begin = "endpoint is \"" + endpoint + "\"; ";
    constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (file.size() > longest)
        return begin + "the path has " + std::to_string(file.size()) + " characters, but at most " +
               std::to_string(longest) + " are possible.";
    struct stat status{};
    if (::lstat(file.c_str(), &status) != 0) {
        if (errno == ENOENT) return {};
        return begin + file + " cannot be inspected: " + std::strerror(errno) + ".";
    }
    if (!S_ISSOCK(status.st_mode))
        return begin + file + " is " + kind_of(status.st_mode) +
               ", which listening there would remove; choose another path, or move it.";
    switch (const int error = connecting_to(file)) {
        case ECONNREFUSED:  // A process that has ended left it.
        case ENOENT:
            return {};
        case 0:
        case EAGAIN:
            return begin + "another process already listens there.";
        default:
            return begin + file + " is a socket that seems to be in use (" + std::strerror(error) +
                   "); choose another path, or remove it.";
    }
}

SocketFile::SocketFile(std::string file) : file_(std::move(file)) {
    if (!file_.empty()) ::lstat(file_.c_str(), &status_);
}

SocketFile::~SocketFile() {
    struct stat now{};
    if (file_.empty() || ::lstat(file_.c_str(), &now) != 0 || !S_ISSOCK(now.st_mode)) return;
    if (now.st_dev == status_.st_dev && now.st_ino == status_.st_ino) ::unlink(file_.c_str());
}

}  // namespace contactd::server

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>
#include <optional>

#include "config/socket_file.hpp"
#include "support/temporary_folder.hpp"

using namespace contactd;
using namespace contactd::server;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

/// Binds a socket to a file; closing it leaves the file.
class UnixSocket {
   public:
    UnixSocket(const fs::path& path, int type) : fd_(::socket(AF_UNIX, type | SOCK_CLOEXEC, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::copy_n(path.c_str(), path.string().size(), address.sun_path);
        REQUIRE(::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
        if (type == SOCK_STREAM) REQUIRE(::listen(fd_, 1) == 0);
    }
    ~UnixSocket() { ::close(fd_); }
    UnixSocket(const UnixSocket&) = delete;
    UnixSocket& operator=(const UnixSocket&) = delete;

   private:
    const int fd_;
};

}  // namespace

TEST_CASE("An endpoint where something is that is no socket is refused, and what is there stays") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "precious";
    std::string kind;
    SECTION("a file") {
        std::ofstream(path) << "precious";
        kind = "a file";
    }
    SECTION("a folder") {
        fs::create_directory(path);
        kind = "a folder";
    }
    SECTION("a link to a file") {
        std::ofstream(folder.path() / "file") << "precious";
        fs::create_symlink(folder.path() / "file", path);
        kind = "a symbolic link";
    }
    SECTION("a link to nothing") {
        fs::create_symlink(folder.path() / "nothing", path);
        kind = "a symbolic link";
    }
    SECTION("a pipe") {
        REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
        kind = "a pipe";
    }

    CHECK_THAT(socket_file_problem("ipc://" + path.string()),
               ContainsSubstring(path.string() + " is " + kind) && ContainsSubstring("another path"));
    CHECK(fs::exists(fs::symlink_status(path)));
}

TEST_CASE("A device is no socket either") {
    CHECK_THAT(socket_file_problem("ipc:///dev/null"), ContainsSubstring("a device"));
}

TEST_CASE("A socket that is in use is refused, one that was left is not") {
    const TemporaryFolder folder;
    const std::string endpoint = "ipc://" + (folder.path() / "s").string();
    CHECK(socket_file_problem(endpoint).empty());
    {
        const UnixSocket other(folder.path() / "s", SOCK_STREAM);
        CHECK_THAT(socket_file_problem(endpoint), ContainsSubstring("another process already listens there"));
    }
    CHECK(fs::exists(folder.path() / "s"));
    CHECK(socket_file_problem(endpoint).empty());
    const UnixSocket log(folder.path() / "log", SOCK_DGRAM);
    CHECK_THAT(socket_file_problem("ipc://" + (folder.path() / "log").string()), ContainsSubstring("in use"));
}

TEST_CASE("Endpoints without a file have no problem with one") {
    CHECK(socket_file_problem("tcp://127.0.0.1:5555").empty());
    CHECK(socket_file_problem("ipc://@abstract").empty());
    CHECK(socket_file_problem("ipc://*").empty());
}

TEST_CASE("At its end a daemon removes its own socket only") {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "s";
    const UnixSocket first(path, SOCK_STREAM);
    SECTION("its own") {
        {
            const SocketFile file(path.string());
        }
        CHECK_FALSE(fs::exists(path));
    }
    SECTION("another one's of the same name") {
        std::optional<UnixSocket> second;
        {
            const SocketFile file(path.string());
            fs::remove(path);
            second.emplace(path, SOCK_STREAM);
        }
        CHECK(fs::exists(path));
    }
    SECTION("a file that took its place") {
        {
            const SocketFile file(path.string());
            fs::remove(path);
            std::ofstream(path) << "precious";
        }
        CHECK(fs::exists(path));
    }
}

// One table as one file: a 512-byte HDF5 user block with the digest, then the HDF5 image.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "contactd/ic_contents.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/ic_store.hpp"
#include "sha256.hpp"
#include "store/hdf5/hdf5_image.hpp"
#include "store/hdf5/writer.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const unsigned char>;

constexpr std::size_t header_size = 512;  // the smallest user block HDF5 skips
constexpr std::string_view any_magic = "contactd ic table, format ";
constexpr std::string_view magic = "contactd ic table, format 1, sha256 of the bytes after this block: ";
constexpr std::size_t digest_size = 64;
constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 32;  // several times the largest that is built

/// Sentences name files and not their folders: they reach clients, who have no business there.
std::string name_of(const fs::path& path) {
    return path.filename().string();
}

[[noreturn]] void fail(const char* doing, const fs::path& path) {
    throw StoreError(std::string("Cannot ") + doing + " " + name_of(path) + ": " + std::strerror(errno) + ".");
}

/// A file descriptor that closes itself.
class File {
   public:
    File(const fs::path& path, int flags, mode_t mode = 0) : fd_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~File() {
        if (fd_ >= 0) ::close(fd_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    bool is_open() const { return fd_ >= 0; }
    int fd() const { return fd_; }

   private:
    int fd_;
};

void write_all(const File& file, Bytes bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.fd(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write", path);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

/// A name may lead anywhere: links are not followed, and what is no file is neither waited for nor read.
std::vector<unsigned char> read_all(const fs::path& path) {
    const File file(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    struct stat status;
    if (!file.is_open() || ::fstat(file.fd(), &status) != 0) fail("read", path);
    if (!S_ISREG(status.st_mode)) throw StoreError(name_of(path) + " is not a regular file.");
    if (static_cast<std::uintmax_t>(status.st_size) > largest_file)
        throw DamagedTable(name_of(path) + " is larger than any table.");
    std::vector<unsigned char> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file.fd(), bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail("read", path);
        if (got == 0) break;
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

/// The block in front of the image has a format of its own, which later versions may count up.
void check_header(Bytes bytes, const fs::path& path) {
    if (bytes.size() > header_size && std::equal(magic.begin(), magic.end(), bytes.begin())) return;
    if (bytes.size() > any_magic.size() && std::equal(any_magic.begin(), any_magic.end(), bytes.begin())) {
        const std::string rest(bytes.begin() + any_magic.size(),
                               bytes.begin() + std::min(bytes.size(), any_magic.size() + 4));
        if (std::atoi(rest.c_str()) > 1) throw NewerFormat(name_of(path) + " was written by a newer contactd.");
    }
    throw DamagedTable(name_of(path) + " is no table of influence coefficients, or its beginning is lost.");
}

void sync_folder(const fs::path& folder) {
    const File file(folder, O_RDONLY | O_DIRECTORY);
    if (!file.is_open() || ::fsync(file.fd()) != 0) fail("sync the folder", folder);
}

std::array<unsigned char, header_size> header_of(Bytes image) {
    std::array<unsigned char, header_size> header{};
    const std::string text = std::string(magic) + sha256_hex(image) + "\n";
    std::copy(text.begin(), text.end(), header.begin());
    return header;
}

/// The temporary file carries a lock while it is written, so that a sweep by another process leaves it alone.
bool lock_and_still_there(const File& file) {
    struct stat status;
    const bool held_by_another = ::flock(file.fd(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    return !held_by_another && ::fstat(file.fd(), &status) == 0 && status.st_nlink > 0;
}

void write_renamed(const fs::path& path, const fs::path& temporary, const File& file, Bytes bytes) {
    try {
        write_all(file, bytes, temporary);
        if (::fsync(file.fd()) != 0) fail("sync", temporary);
        if (::rename(temporary.c_str(), path.c_str()) != 0) fail("rename", temporary);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
    sync_folder(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

}  // namespace

std::vector<unsigned char> to_ic_file(const IcRecord& record) {
    const std::vector<unsigned char> image = to_hdf5(contents_of(record));
    const auto header = header_of(image);
    std::vector<unsigned char> bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), image.begin(), image.end());
    return bytes;
}

void write_ic_file(const fs::path& path, const IcRecord& record) {
    static std::atomic<unsigned> serial{0};
    const std::vector<unsigned char> bytes = to_ic_file(record);
    constexpr int tries = 16;
    for (int n = 0; n < tries; ++n) {
        const fs::path temporary = path.string() + "." + writer_name() + "." + std::to_string(serial++) + ".tmp";
        const File file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0644);
        if (!file.is_open() && errno == EEXIST) continue;
        if (!file.is_open()) fail("create", temporary);
        if (!lock_and_still_there(file)) continue;  // swept between open and lock
        return write_renamed(path, temporary, file, bytes);
    }
    throw StoreError("Cannot create a temporary file beside " + name_of(path) + ".");
}

IcRecord read_ic_file(const fs::path& path) {
    return from_ic_file(read_all(path), path);
}

IcRecord from_ic_file(std::span<const unsigned char> bytes, const fs::path& path) {
    check_header(bytes, path);
    const Bytes image = bytes.subspan(header_size);
    const Bytes digest = bytes.subspan(magic.size(), digest_size);
    const std::string kept(digest.begin(), digest.end());
    if (sha256_hex(image) != kept) throw DamagedTable(name_of(path) + " does not match its digest.");
    try {
        return record_from(from_hdf5(image));
    } catch (const NewerFormat& error) {
        throw NewerFormat(name_of(path) + ": " + error.what());
    } catch (const DamagedTable& error) {
        throw DamagedTable(name_of(path) + ": " + error.what());
    }
}

}  // namespace contactd

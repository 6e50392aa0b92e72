// Stores one table as one file: a 512-byte HDF5 user block with the digest, then the HDF5 image.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "contactd/ic_contents.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/platform.hpp"
#include "sha256.hpp"
#include "store/hdf5/hdf5_image.hpp"
#include "store/hdf5/writer.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;
using platform::OpenFile;
using Bytes = std::span<const unsigned char>;

constexpr std::size_t header_size = 512;  // smallest user block that HDF5 skips
constexpr std::string_view any_magic = "contactd ic table, format ";
constexpr std::string_view magic = "contactd ic table, format 1, sha256 of the bytes after this block: ";
constexpr std::size_t digest_size = 64;
constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 32;  // several times the largest table that is built

/// Messages name files without their folders, because clients receive them and must not learn the folders.
std::string name_of(const fs::path& path) {
    return path.filename().string();
}

[[noreturn]] void fail(const char* doing, const fs::path& path, const std::error_code& error) {
    throw StoreError(std::string("Cannot ") + doing + " " + name_of(path) + ": " + error.message() + ".");
}

/// Reads a file by a name that may refer to anything: links are not followed, and other things than files are neither
/// waited for nor read.
std::vector<unsigned char> read_all(const fs::path& path) {
    OpenFile file(path, OpenFile::Use::reading);
    if (!file.is_open()) fail("read", path, file.error());
    if (!file.is_regular()) throw StoreError(name_of(path) + " is not a regular file.");
    const std::optional<std::uintmax_t> size = file.size();
    if (!size) fail("read", path, file.error());
    if (*size > largest_file) throw DamagedTable(name_of(path) + " is too large for a table.");
    std::vector<unsigned char> bytes(static_cast<std::size_t>(*size));
    const std::optional<std::size_t> have = file.read(bytes);
    if (!have) fail("read", path, file.error());
    bytes.resize(*have);
    return bytes;
}

/// The block in front of the image has its own format, whose number later versions may increase.
void check_header(Bytes bytes, const fs::path& path) {
    if (bytes.size() > header_size && std::equal(magic.begin(), magic.end(), bytes.begin())) return;
    if (bytes.size() > any_magic.size() && std::equal(any_magic.begin(), any_magic.end(), bytes.begin())) {
        const std::string rest(bytes.begin() + any_magic.size(),
                               bytes.begin() + std::min(bytes.size(), any_magic.size() + 4));
        if (std::atoi(rest.c_str()) > 1)
            throw NewerFormat(name_of(path) + " was written by a newer version of contactd.");
    }
    throw DamagedTable(name_of(path) + " is not a table of influence coefficients, or its beginning is lost.");
}

std::array<unsigned char, header_size> header_of(Bytes image) {
    std::array<unsigned char, header_size> header{};
    const std::string text = std::string(magic) + sha256_hex(image) + "\n";
    std::copy(text.begin(), text.end(), header.begin());
    return header;
}

/// The temporary file is locked while it is written, so that a sweep by another process leaves it alone.
bool lock_and_still_there(OpenFile& file) {
    return file.try_lock() != OpenFile::Lock::busy && file.has_name();
}

void write_renamed(const fs::path& path, const fs::path& temporary, OpenFile& file, Bytes bytes) {
    try {
        if (!file.write(bytes)) fail("write", temporary, file.error());
        if (!file.sync()) fail("sync", temporary, file.error());
        if (const std::error_code error = platform::rename_over(temporary, path)) fail("rename", temporary, error);
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (const std::error_code error = platform::sync_folder(folder)) fail("sync the folder", folder, error);
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
        OpenFile file(temporary, OpenFile::Use::writing_new);
        if (!file.is_open() && file.error() == std::errc::file_exists) continue;
        if (!file.is_open()) fail("create", temporary, file.error());
        if (!lock_and_still_there(file)) continue;  // The file was swept between opening and locking.
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

#include "table_file.hpp"

#include <cstring>

#include "contactd/error.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/platform.hpp"
#include "creep_table/file/file_header.hpp"
#include "store/sha256.hpp"

namespace contactd::creep_table {
namespace {

namespace fs = std::filesystem;
using platform::OpenFile;
using Bytes = std::span<const unsigned char>;

template <class T>
std::span<const T> part(Bytes bytes, std::uint64_t from, std::uint64_t to) {
    return {reinterpret_cast<const T*>(bytes.data() + from), static_cast<std::size_t>(to - from) / sizeof(T)};
}

template <class T>
void append(std::vector<unsigned char>& bytes, std::span<const T> values) {
    const auto* const first = reinterpret_cast<const unsigned char*>(values.data());
    bytes.insert(bytes.end(), first, first + values.size_bytes());
}

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
    throw StoreError("Cannot write " + path.filename().string() + ": " + error.message() + ".");
}

}  // namespace

CreepFile parse_creep_file(Bytes bytes, const std::string& name) {
    FileHeader header;
    if (bytes.size() < file_magic.size() || std::memcmp(bytes.data(), file_magic.data(), file_magic.size()) != 0)
        throw DamagedTable(name + " is not a creep-force table of contactd, or its beginning is lost.");
    if (bytes.size() < sizeof header) throw DamagedTable(name + " is incomplete: its header is cut off.");
    std::memcpy(static_cast<void*>(&header), bytes.data(), sizeof header);
    if (header.version > file_version) throw NewerFormat(name + " was written by a newer version of contactd.");
    if (header.version != file_version || !sizes_are_valid(header))
        throw DamagedTable(name + " is damaged: its header states sizes that no table has.");
    const FileOffsets at = offsets_of(header);
    if (header.file_size != at.end) throw DamagedTable(name + " is damaged: the sizes in its header disagree.");
    if (bytes.size() != at.end)
        throw DamagedTable(name + " has " + std::to_string(bytes.size()) + " bytes instead of " +
                           std::to_string(at.end) + ". Copy or download it again.");
    const std::string digest = sha256_hex(bytes.first(static_cast<std::size_t>(at.digest)));
    if (std::memcmp(digest.data(), bytes.data() + at.digest, digest_size) != 0)
        throw DamagedTable(name + " is damaged: its SHA-256 differs. Copy or download it again.");
    if (!ranges_are_valid(header)) throw DamagedTable(name + " states ranges that no table has.");
    CreepFile file = file_of(header);
    const std::span<const char> text = part<char>(bytes, at.description, at.curves);
    file.description = {text.data(), text.size()};
    file.curves = part<double>(bytes, at.curves, at.coefficients);
    file.coefficients = part<float>(bytes, at.coefficients, at.box_coefficients);
    file.box_coefficients = part<float>(bytes, at.box_coefficients, at.bounds);
    file.bounds = part<float>(bytes, at.bounds, at.digest);
    return file;
}

void write_creep_file(const fs::path& path, const CreepFile& file) {
    FileHeader header = header_of(file);
    if (!sizes_are_valid(header) || !ranges_are_valid(header))
        throw InvalidArgument("table", "has sizes or ranges that a file cannot hold");
    header.file_size = offsets_of(header).end;
    std::vector<unsigned char> bytes;
    bytes.reserve(static_cast<std::size_t>(header.file_size));
    append(bytes, std::span<const FileHeader>(&header, 1));
    append(bytes, std::span<const char>(file.description));
    bytes.resize(sizeof header + static_cast<std::size_t>(header.description_size), ' ');
    append(bytes, file.curves);
    append(bytes, file.coefficients);
    append(bytes, file.box_coefficients);
    append(bytes, file.bounds);
    if (bytes.size() + digest_size != header.file_size)
        throw InvalidArgument("table", "has arrays whose sizes differ from its numbers of cells");
    const std::string digest = sha256_hex(bytes);
    append(bytes, std::span<const char>(digest));

    fs::path part_path = path;
    part_path += "." + platform::process_name() + ".part";
    std::error_code ignored;
    fs::remove(part_path, ignored);
    {
        OpenFile out(part_path, OpenFile::Use::writing_new);
        if (!out.is_open() || !out.write(bytes) || !out.sync()) fail(path, out.error());
    }
    if (const std::error_code error = platform::rename_over(part_path, path)) fail(path, error);
    platform::sync_folder(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

}  // namespace contactd::creep_table

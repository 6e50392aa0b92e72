// Implements the platform for Windows 10 and newer.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <bcrypt.h>

#include <algorithm>
#include <atomic>
#include <format>
#include <utility>
#include <vector>

#include "contactd/platform.hpp"

namespace contactd::platform {
namespace {

namespace fs = std::filesystem;

// Locks prevent others from reading and writing the locked bytes, so a byte is locked that no file has.
constexpr DWORD locked_byte_high = 0x7fffffff;

std::error_code last_error() {
    return {static_cast<int>(::GetLastError()), std::system_category()};
}

HANDLE of(std::intptr_t handle) {
    return reinterpret_cast<HANDLE>(handle);
}

HANDLE opened(const fs::path& path, DWORD access, DWORD disposition, DWORD flags) {
    constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    return ::CreateFileW(path.c_str(), access, shared, nullptr, disposition, flags, nullptr);
}

std::optional<BY_HANDLE_FILE_INFORMATION> information_of(HANDLE file) {
    BY_HANDLE_FILE_INFORMATION found;
    if (!::GetFileInformationByHandle(file, &found)) return std::nullopt;
    return found;
}

bool is_same(const BY_HANDLE_FILE_INFORMATION& a, const BY_HANDLE_FILE_INFORMATION& b) {
    return a.dwVolumeSerialNumber == b.dwVolumeSerialNumber && a.nFileIndexHigh == b.nFileIndexHigh &&
           a.nFileIndexLow == b.nFileIndexLow;
}

std::string utf8_of(const wchar_t* text) {
    const std::u8string converted = fs::path(text).u8string();
    return {converted.begin(), converted.end()};
}

}  // namespace

OpenFile::OpenFile(const fs::path& path, Use use) {
    const DWORD access = use == Use::reading       ? GENERIC_READ
                         : use == Use::writing_new ? GENERIC_READ | GENERIC_WRITE | DELETE
                                                   : GENERIC_READ | GENERIC_WRITE;
    const DWORD disposition = use == Use::reading ? OPEN_EXISTING : use == Use::writing_new ? CREATE_NEW : OPEN_ALWAYS;
    const HANDLE handle = opened(path, access, disposition, FILE_ATTRIBUTE_NORMAL | FILE_FLAG_OPEN_REPARSE_POINT);
    if (handle == INVALID_HANDLE_VALUE) {
        error_ = last_error();
        // Callers on every platform compare with this error code of the standard.
        if (error_.value() == ERROR_FILE_EXISTS) error_ = std::make_error_code(std::errc::file_exists);
        return;
    }
    handle_ = reinterpret_cast<std::intptr_t>(handle);
}

OpenFile::~OpenFile() {
    close();
}

OpenFile::OpenFile(OpenFile&& other) noexcept : handle_(std::exchange(other.handle_, none)), error_(other.error_) {}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    if (this == &other) return *this;
    close();
    handle_ = std::exchange(other.handle_, none);
    error_ = other.error_;
    return *this;
}

void OpenFile::close() noexcept {
    if (is_open()) ::CloseHandle(of(handle_));
    handle_ = none;
}

bool OpenFile::is_regular() const {
    constexpr DWORD others = FILE_ATTRIBUTE_DIRECTORY | FILE_ATTRIBUTE_DEVICE | FILE_ATTRIBUTE_REPARSE_POINT;
    const auto found = information_of(of(handle_));
    return found && ::GetFileType(of(handle_)) == FILE_TYPE_DISK && !(found->dwFileAttributes & others);
}

std::optional<std::uintmax_t> OpenFile::size() const {
    LARGE_INTEGER bytes;
    if (!::GetFileSizeEx(of(handle_), &bytes)) return std::nullopt;
    return static_cast<std::uintmax_t>(bytes.QuadPart);
}

bool OpenFile::has_name() const {
    FILE_STANDARD_INFO found;
    return ::GetFileInformationByHandleEx(of(handle_), FileStandardInfo, &found, sizeof found) &&
           !found.DeletePending && found.NumberOfLinks > 0;
}

bool OpenFile::is_at(const fs::path& path) const {
    const HANDLE other = opened(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
    if (other == INVALID_HANDLE_VALUE) return false;
    const auto mine = information_of(of(handle_)), named = information_of(other);
    ::CloseHandle(other);
    return mine && named && is_same(*mine, *named);
}

std::optional<std::size_t> OpenFile::read(std::span<unsigned char> bytes) {
    std::size_t have = 0;
    while (have < bytes.size()) {
        const auto asked = static_cast<DWORD>(std::min<std::size_t>(bytes.size() - have, 1u << 30));
        DWORD got = 0;
        if (!::ReadFile(of(handle_), bytes.data() + have, asked, &got, nullptr)) {
            error_ = last_error();
            return std::nullopt;
        }
        if (got == 0) break;
        have += got;
    }
    return have;
}

bool OpenFile::write(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
        const auto asked = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), 1u << 30));
        DWORD written = 0;
        if (!::WriteFile(of(handle_), bytes.data(), asked, &written, nullptr)) {
            error_ = last_error();
            return false;
        }
        bytes = bytes.subspan(written);
    }
    return true;
}

bool OpenFile::sync() {
    if (::FlushFileBuffers(of(handle_))) return true;
    error_ = last_error();
    return false;
}

OpenFile::Lock OpenFile::try_lock() {
    OVERLAPPED place{};
    place.OffsetHigh = locked_byte_high;
    if (::LockFileEx(of(handle_), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place))
        return Lock::held;
    error_ = last_error();
    const bool is_busy = error_.value() == ERROR_LOCK_VIOLATION || error_.value() == ERROR_IO_PENDING;
    return is_busy ? Lock::busy : Lock::unavailable;
}

void OpenFile::note_change() const {
    FILETIME now;
    ::GetSystemTimeAsFileTime(&now);
    ::SetFileTime(of(handle_), nullptr, nullptr, &now);
}

MappedFile::MappedFile(const fs::path& path) {
    const OpenFile file(path, OpenFile::Use::reading);
    const std::optional<std::uintmax_t> size = file.is_open() ? file.size() : std::nullopt;
    if (!size || !file.is_regular()) {
        error_ = file.is_open() ? std::make_error_code(std::errc::invalid_argument) : file.error();
        return;
    }
    if (*size == 0) return;
    const HANDLE mapping = ::CreateFileMappingW(of(file.handle_), nullptr, PAGE_READONLY, 0, 0, nullptr);
    void* const begin = mapping ? ::MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0) : nullptr;
    if (begin)
        bytes_ = {static_cast<const unsigned char*>(begin), static_cast<std::size_t>(*size)};
    else
        error_ = last_error();
    if (mapping) ::CloseHandle(mapping);  // the view keeps it
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::UnmapViewOfFile(bytes_.data());
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})), error_(other.error_) {}

std::error_code rename_over(const fs::path& from, const fs::path& to) {
    const bool done = ::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
    return done ? std::error_code() : last_error();
}

std::error_code sync_folder(const fs::path&) {
    return {};
}

std::error_code cannot_make_file(const fs::path& folder) {
    static std::atomic<unsigned> serial{0};
    const fs::path name = folder / std::format(".contactd-{}-{}", ::GetCurrentProcessId(), serial++);
    const HANDLE made = opened(name, GENERIC_WRITE | DELETE, CREATE_ALWAYS, FILE_FLAG_DELETE_ON_CLOSE);
    if (made == INVALID_HANDLE_VALUE) return last_error();
    ::CloseHandle(made);
    return {};
}

std::error_code cannot_use(const fs::path& folder, bool written) {
    std::error_code error;
    (void)fs::directory_iterator(folder, error);
    if (error) return error;
    return written ? cannot_make_file(folder) : error;
}

std::string boot_name() {
    // Windows has no name for a boot of the machine. The start times of processes are absolute, so that the name only
    // needs to distinguish machines.
    unsigned long long digest = 14695981039346656037u;
    for (const char c : host_name()) digest = (digest ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return std::format("{:012x}", digest & 0xffffffffffffu);
}

std::string process_name() {
    return std::to_string(::GetCurrentProcessId());
}

std::string start_of(const std::string& process) {
    DWORD id = 0;
    for (const char c : process) {
        if (c < '0' || c > '9') return "0";
        id = 10 * id + static_cast<DWORD>(c - '0');
    }
    const HANDLE handle = ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, id);
    if (!handle) return "0";
    FILETIME start{}, end{}, kernel{}, user{};
    DWORD status = 0;
    const bool runs = ::GetExitCodeProcess(handle, &status) && status == STILL_ACTIVE &&
                      ::GetProcessTimes(handle, &start, &end, &kernel, &user);
    ::CloseHandle(handle);
    if (!runs) return "0";
    return std::to_string(static_cast<unsigned long long>(start.dwHighDateTime) << 32 | start.dwLowDateTime);
}

std::string host_name() {
    wchar_t name[MAX_COMPUTERNAME_LENGTH + 1] = {};
    DWORD size = MAX_COMPUTERNAME_LENGTH + 1;
    if (!::GetComputerNameW(name, &size)) return "0";
    std::string host = utf8_of(name);
    std::replace_if(host.begin(), host.end(), [](char c) { return c == '/' || c == '\\' || c == '.'; }, '_');
    return host;
}

void random_bytes(std::span<unsigned char> bytes) {
    const NTSTATUS status =
        ::BCryptGenRandom(nullptr, bytes.data(), static_cast<ULONG>(bytes.size()), BCRYPT_USE_SYSTEM_PREFERRED_RNG);
    if (status < 0) throw std::system_error(std::make_error_code(std::errc::io_error), "BCryptGenRandom");
}

std::string variable(const char* name) {
    const std::wstring named = fs::path(name).wstring();
    std::vector<wchar_t> value(::GetEnvironmentVariableW(named.c_str(), nullptr, 0));
    if (value.empty()) return {};
    ::GetEnvironmentVariableW(named.c_str(), value.data(), static_cast<DWORD>(value.size()));
    return utf8_of(value.data());
}

fs::path cache_folder() {
    return variable("LOCALAPPDATA");
}

}  // namespace contactd::platform

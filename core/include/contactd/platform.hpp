// Files, processes and the environment of the operating system: apart from simd.hpp, the only code that depends on it.
// core/src/platform implements it for POSIX and for Windows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>

namespace contactd::platform {

/// A file that is open during the lifetime of this object. Child processes do not inherit it, links are not followed,
/// and opening never waits for pipes or devices. Others may rename and remove it.
class OpenFile {
   public:
    enum class Use {
        reading,      ///< an existing file
        writing_new,  ///< a new file, which must not exist
        locking       ///< a file that is created if missing
    };
    OpenFile(const std::filesystem::path& path, Use use);
    ~OpenFile();
    OpenFile(OpenFile&& other) noexcept;
    OpenFile& operator=(OpenFile&& other) noexcept;

    bool is_open() const { return handle_ != none; }
    /// Returns the reason why it is not open, or why the last call failed.
    std::error_code error() const { return error_; }
    bool is_regular() const;
    /// (bytes); none if it cannot be determined.
    std::optional<std::uintmax_t> size() const;
    /// False once the file has been removed.
    bool has_name() const;
    /// False if the file at `path` is another one, or missing.
    bool is_at(const std::filesystem::path& path) const;

    /// Reads until `bytes` is full or the file ends; returns their number, or none on failure.
    std::optional<std::size_t> read(std::span<unsigned char> bytes);
    /// Writes all bytes; returns false on failure.
    bool write(std::span<const unsigned char> bytes);
    /// Returns false if the data are not on the disk.
    bool sync();

    enum class Lock { held, busy, unavailable };
    /// Locks it against other holders of this lock, in other processes, too, until the file is closed, without waiting.
    Lock try_lock();
    /// Sets the time of the last change to the present.
    void note_change() const;

   private:
    static constexpr std::intptr_t none = -1;
    void close() noexcept;

    std::intptr_t handle_ = none;
    std::error_code error_;
};

/// Renames the file, replacing a file with that name; on Windows, durably.
std::error_code rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
/// Waits until the names in a folder are durable; on Windows rename_over does so.
std::error_code sync_folder(const std::filesystem::path& folder);

/// Returns the reason why no file can be created in the folder, by creating one; none if it is possible.
std::error_code cannot_make_file(const std::filesystem::path& folder);
/// Returns the reason why the folder cannot be read, or `written`, according to its permissions.
std::error_code cannot_use(const std::filesystem::path& folder, bool written);

/// Returns letters and digits that identify the boot of this machine or, if unavailable, the machine.
std::string boot_name();
std::string process_name();
/// Returns the start time of the process with this ID in units of the system; "0" if there is none.
std::string start_of(const std::string& process);
/// Returns the name of this machine, without dots and slashes.
std::string host_name();

/// Fills `bytes` with cryptographically random data. Throws std::system_error.
void random_bytes(std::span<unsigned char> bytes);

/// Returns a variable of the environment in UTF-8; empty if it is not set.
std::string variable(const char* name);
/// Returns the user's cache folder; empty if it is not defined.
std::filesystem::path cache_folder();

}  // namespace contactd::platform

// Accesses files, processes and the environment of the operating system. Apart from simd.hpp, it is the only code that
// depends on the system. core/src/platform implements it for POSIX and for Windows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>

namespace contactd::platform {

/// Holds a file open during the lifetime of this object. Child processes do not inherit it, links are not followed, and
/// opening never waits for pipes or devices. Other processes may rename and remove it.
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
    /// Returns the reason why the file is not open, or why the last call failed.
    std::error_code error() const { return error_; }
    bool is_regular() const;
    /// Returns the size (bytes), if it can be determined.
    std::optional<std::uintmax_t> size() const;
    /// Returns whether the file still has a name: false after it was removed.
    bool has_name() const;
    /// Returns whether `path` names this file: false if it is missing or another file.
    bool is_at(const std::filesystem::path& path) const;

    /// Reads until `bytes` is full or the file ends. Returns the number of bytes, or nothing on failure.
    std::optional<std::size_t> read(std::span<unsigned char> bytes);
    /// Writes all bytes; returns false on failure.
    bool write(std::span<const unsigned char> bytes);
    /// Returns false if the data are not on the disk.
    bool sync();

    enum class Lock { held, busy, unavailable };
    /// Locks the file without waiting, until it is closed, against other holders of this lock, including those in other
    /// processes.
    Lock try_lock();
    /// Sets the time of the last change to the present.
    void note_change() const;

   private:
    friend class MappedFile;
    static constexpr std::intptr_t none = -1;
    void close() noexcept;

    std::intptr_t handle_ = none;
    std::error_code error_;
};

/// Maps a regular file into memory for reading during the lifetime of this object. The file must not be shortened
/// meanwhile; renaming another file over it is safe.
class MappedFile {
   public:
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&&) = delete;

    /// Returns the contents, which start at a multiple of 64 bytes, or nothing if the file is empty or not mapped.
    std::span<const unsigned char> bytes() const { return bytes_; }
    /// Returns the reason why the file is not mapped.
    std::error_code error() const { return error_; }

   private:
    std::span<const unsigned char> bytes_{};
    std::error_code error_;
};

/// Renames the file, replacing a file with that name; on Windows, durably.
std::error_code rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
/// Waits until the names in a folder are durable; on Windows rename_over does so.
std::error_code sync_folder(const std::filesystem::path& folder);

/// Returns the reason why no file can be created in the folder, by creating one. The code is empty if it is possible.
std::error_code cannot_make_file(const std::filesystem::path& folder);
/// Returns the reason why the folder cannot be read or, with `written`, cannot be written, according to its
/// permissions.
std::error_code cannot_use(const std::filesystem::path& folder, bool written);

/// Returns letters and digits that identify the boot of this machine or, if unavailable, the machine.
std::string boot_name();
std::string process_name();
/// Returns the start time of the process with this ID in units of the system, or "0" if there is no such process.
std::string start_of(const std::string& process);
/// Returns the name of this machine, without dots and slashes.
std::string host_name();

/// Fills `bytes` with cryptographically random data. Throws std::system_error.
void random_bytes(std::span<unsigned char> bytes);

/// Returns a variable of the environment in UTF-8, or an empty string if it is not set.
std::string variable(const char* name);
/// Returns the user's cache folder, or an empty path if it is not defined.
std::filesystem::path cache_folder();

}  // namespace contactd::platform

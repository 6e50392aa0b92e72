// Files, processes and the environment as operating systems have them: beside simd.hpp the one place that knows which
// one it is. core/src/platform has it once for POSIX and once for Windows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>

namespace contactd::platform {

/// A file that is open as long as this lives. Programs that are started meanwhile do not inherit it, links are not
/// followed, and what is no file makes nobody wait. Others may rename and remove it.
class OpenFile {
   public:
    enum class Use {
        reading,      ///< of a file that is there
        writing_new,  ///< of a file that must not be there yet
        locking       ///< of a file that is made where it is missing
    };
    OpenFile(const std::filesystem::path& path, Use use);
    ~OpenFile();
    OpenFile(OpenFile&& other) noexcept;
    OpenFile& operator=(OpenFile&& other) noexcept;

    bool is_open() const { return handle_ != none; }
    /// Why it is not open, or why the last call has failed.
    std::error_code error() const { return error_; }
    bool is_regular() const;
    /// (bytes); nothing where it cannot be found out.
    std::optional<std::uintmax_t> size() const;
    /// False once the file has been removed.
    bool has_name() const;
    /// False when the file at `path` is another one, or none.
    bool is_at(const std::filesystem::path& path) const;

    /// Reads until `bytes` is full or the file ends; how many, or nothing when it fails.
    std::optional<std::size_t> read(std::span<unsigned char> bytes);
    /// Writes all of it; false when it fails.
    bool write(std::span<const unsigned char> bytes);
    /// False when the disk has not got it.
    bool sync();

    enum class Lock { held, busy, unavailable };
    /// Locks it against other holders of this lock, in other processes, too, until the file is closed, without waiting.
    Lock try_lock();
    /// Makes the present the time of the last change.
    void note_change() const;

   private:
    static constexpr std::intptr_t none = -1;
    void close() noexcept;

    std::intptr_t handle_ = none;
    std::error_code error_;
};

/// Gives the file another name, in place of the file that has it; on Windows so that the name lasts.
std::error_code rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
/// Waits until the names of a folder last; on Windows rename_over has.
std::error_code sync_folder(const std::filesystem::path& folder);

/// Why no file can be made in the folder, found out by making one; none when one can.
std::error_code cannot_make_file(const std::filesystem::path& folder);
/// Why the folder cannot be read, or also not `written`, as far as permissions tell.
std::error_code cannot_use(const std::filesystem::path& folder, bool written);

/// Letters and digits that another start of this machine has not, or, where there are none, another machine.
std::string boot_name();
std::string process_name();
/// When the process of this name has started, in units of the system; "0" where there is none.
std::string start_of(const std::string& process);
/// Returns the name of this machine, without dots and slashes.
std::string host_name();

/// Fills `bytes` with what nobody can guess. Throws std::system_error.
void random_bytes(std::span<unsigned char> bytes);

/// A variable of the environment in UTF-8; empty where it is not set.
std::string variable(const char* name);
/// Where programs of the user keep what they can make again; empty where nothing says so.
std::filesystem::path cache_folder();

}  // namespace contactd::platform

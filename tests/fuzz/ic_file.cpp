// An IC file up to its digest: HDF5, which is not made for hostile files, must never see one that fails.
#include <sys/mman.h>
#include <unistd.h>

#include "contactd/ic_store.hpp"
#include "input.hpp"

namespace {

/// A file in memory; the path goes with it.
class MemoryFile {
   public:
    explicit MemoryFile(std::string_view bytes) : fd_(::memfd_create("fuzz", MFD_CLOEXEC)) {
        fuzz::require(fd_ >= 0 && ::write(fd_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
                      "a file in memory can be made");
    }
    ~MemoryFile() { ::close(fd_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

   private:
    int fd_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const MemoryFile file(fuzz::bytes_of(data, size));
    try {
        (void)contactd::read_ic_file(file.path());
    } catch (const contactd::DamagedTable&) {
    }
    return 0;
}

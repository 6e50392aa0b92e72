// Manages the file of an ipc endpoint, which listening there replaces.
#pragma once

#include <sys/stat.h>

#include <string>

namespace contactd::server {

/// Returns the file of an ipc endpoint; empty for other endpoints, including abstract names.
std::string socket_file(const std::string& endpoint);

/// Returns the reason why the daemon must not listen there, as a sentence: the path is not a socket, or a socket in
/// use. Empty if there is no file, or a socket left by a process that has ended.
std::string socket_file_problem(const std::string& endpoint);

/// Removes the file of a listening socket in the destructor, unless another socket has taken its name.
class SocketFile {
   public:
    explicit SocketFile(std::string file);
    ~SocketFile();
    SocketFile(const SocketFile&) = delete;
    SocketFile& operator=(const SocketFile&) = delete;

   private:
    const std::string file_;
    struct stat status_{};
};

}  // namespace contactd::server

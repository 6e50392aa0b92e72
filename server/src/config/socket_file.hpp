// The file of an ipc endpoint, which listening there replaces.
#pragma once

#include <sys/stat.h>

#include <string>

namespace contactd::server {

/// The file of an ipc endpoint; empty for others, abstract names among them.
std::string socket_file(const std::string& endpoint);

/// Why nobody should listen there, a sentence: something is there that is no socket, or one that is in use. Empty when
/// there is nothing, or a socket that a process left which has ended.
std::string socket_file_problem(const std::string& endpoint);

/// Removes the file of a socket that listens, at its end, unless another one has taken its name by then.
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

// libzmq 4.3 aborts the program if a connection arrives at an ipc endpoint and no file descriptor is left (EMFILE),
// although it handles the same shortage of the whole system (ENFILE). This accept4, which libzmq finds before that of
// the C library, reports the latter.
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

extern "C" int accept4(int socket, sockaddr* address, socklen_t* length, int flags) {
    const auto accepted = static_cast<int>(::syscall(SYS_accept4, socket, address, length, flags));
    if (accepted < 0 && errno == EMFILE) {
        // The connection stays in the queue, and libzmq retries immediately, which would occupy a processor without a
        // pause.
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        errno = ENFILE;
    }
    return accepted;
}

// Reads CURVE key files of encrypted connections, and explains failed handshakes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <zmq.hpp>

namespace contactd::client {

/// Holds the daemon's public key and the client's own pair, in Z85.
struct CurveKeys {
    std::string server, own_public, own_secret;

    /// Makes the socket encrypt its messages; call it before the socket connects.
    void apply(zmq::socket_t& socket) const;
};

/// Reads the daemon's public key file and the client's secret key file; none if neither is given. Throws
/// contactd::Error naming the invalid file or the missing option.
std::optional<CurveKeys> load_curve_keys(const std::filesystem::path& server_key, const std::filesystem::path& own_key);

/// Monitors the handshakes of a socket, from before it connects.
class HandshakeMonitor {
   public:
    /// `channel` is an inproc address that this context has not used yet.
    HandshakeMonitor(zmq::context_t& context, zmq::socket_t& watched, const std::string& channel, std::string endpoint,
                     bool encrypted);
    ~HandshakeMonitor();
    HandshakeMonitor(const HandshakeMonitor&) = delete;
    HandshakeMonitor& operator=(const HandshakeMonitor&) = delete;

    /// Readable after an event.
    void* handle() { return events_.handle(); }
    /// Throws StatusError (UNAUTHENTICATED) or ConnectionError if a connection is impossible.
    void check();
    /// Clears earlier events after a connection is made.
    void forget();

   private:
    struct Event {
        int kind = 0;  ///< 0: none
        int value = 0;
    };
    Event next();
    void judge(const Event& event);

    zmq::socket_t& watched_;
    const std::string endpoint_;
    const bool encrypted_;
    int silent_ends_ = 0;
    zmq::socket_t events_;
};

}  // namespace contactd::client

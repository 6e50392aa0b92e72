// Encrypted connections: the key files of CURVE, and what a handshake that failed says.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <zmq.hpp>

namespace contactd::client {

/// The daemon's public key and the client's own pair, in Z85.
struct CurveKeys {
    std::string server, own_public, own_secret;

    /// Makes the socket encrypt what it sends; before it connects.
    void apply(zmq::socket_t& socket) const;
};

/// Reads the daemon's public file and the client's own secret one; none when neither is given. Throws contactd::Error
/// naming the file that cannot be used or the option that is missing.
std::optional<CurveKeys> load_curve_keys(const std::filesystem::path& server_key, const std::filesystem::path& own_key);

/// Listens to what happens to the handshakes of a socket, from before it connects.
class HandshakeMonitor {
   public:
    /// `channel` is an inproc address that this context has not used yet.
    HandshakeMonitor(zmq::context_t& context, zmq::socket_t& watched, const std::string& channel, std::string endpoint,
                     bool encrypted);
    ~HandshakeMonitor();
    HandshakeMonitor(const HandshakeMonitor&) = delete;
    HandshakeMonitor& operator=(const HandshakeMonitor&) = delete;

    /// Readable when something happened.
    void* handle() { return events_.handle(); }
    /// Throws StatusError (UNAUTHENTICATED) or ConnectionError when there is no hope of a connection.
    void check();
    /// Forgets what happened, once there is a connection.
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

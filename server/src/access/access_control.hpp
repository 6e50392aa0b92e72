// Controls the access of clients, and determines the sender of a message.
#pragma once

#include <string>
#include <vector>
#include <zmq.hpp>

#include "config/config.hpp"
#include "contactd/proto/status.hpp"
#include "curve_keys.hpp"

namespace contactd::server {

/// Answers a user with a revoked key.
proto::Status key_revoked();

/// Decides on connections by ZeroMQ's authentication protocol (ZAP, RFC 27): with CURVE only holders of allowed keys
/// may connect, otherwise all clients. Belongs to the I/O thread. Every message has the decision in its property
/// User-Id: the public key with CURVE, otherwise the location of the client. Names are looked up for each message,
/// because a key may have been revoked after its connection was made.
class AccessControl {
   public:
    /// Reads the keys and binds ZAP's address in `context`. Throws Error if a key cannot be used.
    AccessControl(const Config& config, zmq::context_t& context);

    /// Sets the options of a socket before it is bound.
    void protect(zmq::socket_t& socket) const;

    /// Returns the socket that is readable if there are requests; answer_all answers them.
    void* handle() { return socket_.handle(); }
    void answer_all();

    /// Returns the user who sent a message: the name of the key; without CURVE, the client's address or uid:NUMBER over
    /// ipc. Empty if the key is no longer allowed.
    std::string user_of(const zmq::message_t& part) const;

    /// Returns false for a user of user_of whose key has since been revoked.
    bool knows(const std::string& user) const { return !encrypted() || allowed_.has_user(user); }

    /// Reads the folder of allowed keys again and logs its problems. If it cannot be read, nothing changes.
    void reload();

   private:
    bool encrypted() const { return !config_.security.curve.secret_key_file.empty(); }
    void read_allowed();
    /// Returns the User-Id of an accepted connection, or an empty text.
    std::string admitted(const std::vector<zmq::message_t>& question) const;

    const Config& config_;
    std::string secret_key_;
    AllowedKeys allowed_;
    zmq::socket_t socket_;
};

}  // namespace contactd::server

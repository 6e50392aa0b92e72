// Access of clients, and the sender of a message.
#pragma once

#include <string>
#include <vector>
#include <zmq.hpp>

#include "config/config.hpp"
#include "contactd/proto/status.hpp"
#include "curve_keys.hpp"

namespace contactd::server {

/// The answer to a user whose key has been revoked.
proto::Status key_revoked();

/// Answers ZeroMQ's question, by its authentication protocol (ZAP, RFC 27), whether a connection may be made: with
/// CURVE only to holders of allowed keys, otherwise to everybody. Belongs to the I/O thread.
///
/// Every message carries the answer with it, as the property User-Id: the public key with CURVE, else where the client
/// is. Names are looked up for each message, since a key may have been revoked after its connection was made.
class AccessControl {
   public:
    /// Reads the keys and takes ZAP's address in `context`. Throws Error when a key cannot be used.
    AccessControl(const Config& config, zmq::context_t& context);

    /// Sets what a socket needs before it is bound.
    void protect(zmq::socket_t& socket) const;

    /// Readable when there are questions; answer_all answers them.
    void* handle() { return socket_.handle(); }
    void answer_all();

    /// The user who sent a message: the name of the key; without CURVE, the client's address or uid:NUMBER over ipc.
    /// Empty when the key is not allowed any more.
    std::string user_of(const zmq::message_t& part) const;

    /// False for a user of user_of whose key has been revoked since.
    bool knows(const std::string& user) const { return !encrypted() || allowed_.has_user(user); }

    /// Reads the folder of allowed keys again; the log says what is wrong with it. A folder that cannot be read changes
    /// nothing.
    void reload();

   private:
    bool encrypted() const { return !config_.security.curve.secret_key_file.empty(); }
    void read_allowed();
    /// The User-Id of a connection that may be made, empty for one that may not.
    std::string admitted(const std::vector<zmq::message_t>& question) const;

    const Config& config_;
    std::string secret_key_;
    AllowedKeys allowed_;
    zmq::socket_t socket_;
};

}  // namespace contactd::server

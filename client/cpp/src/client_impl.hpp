// What the parts of the client share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "connection.hpp"
#include "contactd/client/client.hpp"

namespace contactd::client {

using nlohmann::json;

class Client::Impl {
   public:
    Impl(const std::string& endpoint, ClientOptions options)
        : options_(std::move(options)),
          connection_(endpoint, options_.connect_timeout, options_.limits,
                      load_curve_keys(options_.server_key, options_.own_key)) {}

    Reply call(const std::string& method, json params, std::vector<std::string> frames, const CallOptions& options,
               std::chrono::milliseconds default_timeout) {
        ProgressHandler on_progress;
        if (options.on_progress)
            on_progress = [&](const json& progress) {
                options.on_progress({progress.value("job", ""), progress["stage"].get<std::string>(),
                                     progress["fraction"].get<double>(), progress.value("iteration", 0),
                                     progress.value("residual", 0.0), progress.value("state", "")});
            };
        return connection_.call(method, std::move(params), std::move(frames), options.timeout.value_or(default_timeout),
                                on_progress, options.stop);
    }

    json quick(const std::string& method, const CallOptions& options, json params = json::object()) {
        return call(method, std::move(params), {}, options, options_.timeout).result;
    }

    const ClientOptions& options() const { return options_; }

   private:
    ClientOptions options_;
    Connection connection_;
};

/// An array of the answer that does not fit is the daemon's fault, not the caller's.
template <class Decode>
auto decoded(const Decode& decode) {
    try {
        return decode();
    } catch (const proto::StatusError& error) {
        throw ProtocolError(std::string("The daemon's answer cannot be read: ") + error.what() + ".");
    }
}

}  // namespace contactd::client

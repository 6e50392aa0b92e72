// Provides a daemon with scripted answers.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>
#include <zmq.hpp>

#include "contactd/proto/frame.hpp"

namespace fake {

/// Holds envelope and frames of a message.
using Frames = contactd::proto::Frames;

class Daemon {
   public:
    /// Returns the messages to send back for a request, in order.
    using Script = std::function<std::vector<Frames>(const nlohmann::json& request, const Frames& frames)>;

    explicit Daemon(Script script);
    ~Daemon();
    const std::string& endpoint() const { return endpoint_; }

   private:
    void run();

    Script script_;
    zmq::context_t context_;
    zmq::socket_t socket_;
    std::string endpoint_;
    std::atomic<bool> stop_ = false;
    std::thread thread_;
};

std::string reply(const nlohmann::json& request, const nlohmann::json& result);
std::string failure(const nlohmann::json& request, const nlohmann::json& status);
std::string progress(const nlohmann::json& request, const nlohmann::json& progress);

}  // namespace fake

// Defines the limits of one message.
#pragma once

#include <cstddef>

namespace contactd {

/// server.info publishes these limits, and server and clients enforce them.
struct MessageLimits {
    std::size_t max_frame_bytes = 128u << 20;
    std::size_t max_frames = 8192;  ///< including the envelope
    std::size_t max_message_bytes = 256u << 20;
    std::size_t max_array_elements = 16'000'000;

    bool operator==(const MessageLimits&) const = default;
};

}  // namespace contactd

// Limits of one message.
#pragma once

#include <cstddef>

namespace contactd {

/// Published by server.info, enforced by server and clients.
struct MessageLimits {
    std::size_t max_frame_bytes = 128u << 20;
    std::size_t max_frames = 8192;  ///< the envelope included
    std::size_t max_message_bytes = 256u << 20;
    std::size_t max_array_elements = 16'000'000;

    bool operator==(const MessageLimits&) const = default;
};

}  // namespace contactd

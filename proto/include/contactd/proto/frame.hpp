// Holds the bytes of an array that follows an envelope.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace contactd::proto {

/// Holds the source of its bytes, so that large arrays are copied neither by the sender nor by the receiver. Copies of
/// a frame share the bytes, which are immutable.
class Frame {
   public:
    Frame() = default;
    Frame(std::string bytes) {
        const auto held = std::make_shared<const std::string>(std::move(bytes));
        *this = Frame(held, *held);
    }
    Frame(const char* text) : Frame(std::string(text)) {}
    template <class Number, class Allocator>
    explicit Frame(std::vector<Number, Allocator> values) {
        const auto held = std::make_shared<const std::vector<Number, Allocator>>(std::move(values));
        *this = Frame(held, {reinterpret_cast<const char*>(held->data()), held->size() * sizeof(Number)});
    }
    /// Bytes of a message received by a socket.
    template <class Message>
        requires requires(const Message& message) { message.to_string_view(); }
    explicit Frame(Message message) {
        const auto held = std::make_shared<const Message>(std::move(message));
        *this = Frame(held, held->to_string_view());
    }
    /// Bytes within another object, which is kept alive.
    Frame(std::shared_ptr<const void> owner, std::string_view bytes) : owner_(std::move(owner)), bytes_(bytes) {}

    std::string_view bytes() const { return bytes_; }
    const char* data() const { return bytes_.data(); }
    std::size_t size() const { return bytes_.size(); }

    bool operator==(const Frame& other) const { return bytes_ == other.bytes_; }

   private:
    std::shared_ptr<const void> owner_;
    std::string_view bytes_;
};

using Frames = std::vector<Frame>;

}  // namespace contactd::proto

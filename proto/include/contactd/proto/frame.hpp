// The bytes of an array that travels behind an envelope.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace contactd::proto {

/// Holds what its bytes were made of, as it is: neither who makes one of a large array, nor who receives it, copies it.
/// Copies of a frame share those bytes, which nobody changes any more.
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
    /// Bytes of a message as a socket gave it.
    template <class Message>
        requires requires(const Message& message) { message.to_string_view(); }
    explicit Frame(Message message) {
        const auto held = std::make_shared<const Message>(std::move(message));
        *this = Frame(held, held->to_string_view());
    }
    /// Bytes within something else, which is kept for as long as they are wanted.
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

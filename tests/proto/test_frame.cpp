#include "contactd/proto/frame.hpp"

#include <catch2/catch_test_macros.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace contactd::proto;

namespace {

// Creates a message like that of a socket.
struct Message {
    std::vector<char> bytes;
    std::string_view to_string_view() const { return {bytes.data(), bytes.size()}; }
};

const std::string text = "longer than what a string keeps within itself";

}  // namespace

TEST_CASE("A frame keeps the memory of what it is made of", "[frame]") {
    std::string characters = text;
    const void* memory = characters.data();
    CHECK(Frame(std::move(characters)).data() == memory);

    std::vector<double> numbers{1, 2};
    memory = numbers.data();
    const Frame of_numbers(std::move(numbers));
    CHECK(of_numbers.data() == memory);
    CHECK(of_numbers.bytes() == std::string_view("\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x40", 16));

    Message message{{'o', 'n', 'e'}};
    memory = message.bytes.data();
    const Frame of_message(std::move(message));
    CHECK(of_message.data() == memory);
    CHECK(of_message.bytes() == "one");
}

TEST_CASE("Copies of a frame share its bytes, and outlive it", "[frame]") {
    Frame copy;
    CHECK(copy.size() == 0);
    {
        const Frame frame(text);
        copy = frame;
        CHECK(copy.data() == frame.data());
    }
    CHECK(copy.bytes() == text);
    CHECK(copy == Frame(text));
    CHECK_FALSE(copy == Frame("another"));
}

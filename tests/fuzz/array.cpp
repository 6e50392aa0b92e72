// Fuzzes one array: it is refused with a message, or read; a read array is the same after it is written and read again.
#include <algorithm>

#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "input.hpp"

using namespace contactd::proto;

namespace {

using Shape = std::vector<std::size_t>;
constexpr std::size_t max_axes = 4, max_extent = 8;

/// The first byte is the number of axes, followed by the extent of each.
Shape take_shape(std::string_view& bytes) {
    const auto take = [&](std::size_t below) {
        const auto byte = static_cast<unsigned char>(bytes.empty() ? 1 : bytes.front());
        if (!bytes.empty()) bytes.remove_prefix(1);
        return byte % below;
    };
    Shape shape(1 + take(max_axes));
    for (std::size_t& extent : shape) extent = take(max_extent);
    return shape;
}

template <class T, class Read>
void check(const Read& read, const nlohmann::json& source, const Frames& frames, const Shape& shape) {
    std::vector<T> values;
    try {
        values = read(source, frames, shape, "field");
    } catch (const StatusError& error) {
        fuzz::require(error.status().message.size() < 2000, "a refusal is no longer than it must be");
        (void)dump(to_json(error.status()));
        return;
    }
    for (const ArrayEncoding encoding : {ArrayEncoding::frame, ArrayEncoding::list}) {
        // A list does not contain the length of the axes after an empty one.
        if (values.empty() && shape.size() > 1) return;
        ArrayWriter arrays(encoding);
        const nlohmann::json written = arrays.write(values, shape);
        const std::vector<T> again = read(nlohmann::json::parse(dump(written)), arrays.take_frames(), shape, "again");
        fuzz::require(again == values, "an array that is sent arrives as it was");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view bytes = fuzz::bytes_of(data, size);
    const Shape shape = take_shape(bytes);
    const fuzz::Input input = fuzz::split(bytes);
    const auto source = nlohmann::json::parse(input.text, nullptr, false);
    if (source.is_discarded()) return 0;
    const Frames frames(input.frames.begin(), input.frames.end());
    check<double>(read_array, source, frames, shape);
    check<unsigned char>(read_byte_array, source, frames, shape);
    try {
        check_frames_used(source, frames);
    } catch (const StatusError&) {
    }
    return 0;
}

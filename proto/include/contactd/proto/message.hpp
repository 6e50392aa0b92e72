// Reads and writes the envelope and its array frames (docs/protocol.md).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/error.hpp"
#include "contactd/message_limits.hpp"
#include "contactd/proto/frame.hpp"
#include "contactd/unset_array.hpp"

namespace contactd::proto {

inline constexpr int protocol_version = 1;
/// Lists versions supported by the daemon, oldest first.
inline constexpr std::array<int, 1> protocol_versions{1};

nlohmann::json to_json(const MessageLimits& limits);

/// Frame 0 is the JSON envelope; `frames[n-1]` contains the bytes of frame n.
struct Message {
    nlohmann::json envelope;
    Frames frames;
};

/// Selects the form of arrays in the reply.
enum class ArrayEncoding { frame, list };

/// Priority of a request; higher ones are first.
enum class Priority { high, normal, low };

/// Holds a request after its envelope has been checked. `params` is checked against the method's schema separately.
struct Request {
    std::string id;
    std::string method;
    nlohmann::json params;    ///< an object
    nlohmann::json metadata;  ///< an object of plain values
    int timeout_ms = 0;       ///< 0: none
    ArrayEncoding arrays = ArrayEncoding::frame;
    std::optional<Priority> priority;  ///< absent: that of the method
    Frames frames;
    std::size_t bytes = 0;  ///< of the received message
};

/// Parses frame 0 and checks the envelope. Throws StatusError (NOT_JSON, NOT_AN_OBJECT, PROTOCOL_VERSION,
/// ENVELOPE_INVALID, LIMIT_EXCEEDED); `id_out` receives the ID as soon as it is read, so that the error can be
/// answered.
Request parse_request(std::string_view envelope, Frames frames, const MessageLimits& limits, std::string& id_out);

/// Returns the text of an envelope. Replaces invalid UTF-8, and never contains NaN.
std::string dump(const nlohmann::json& json);

/// Whether equal arrays of a message are sent once, which is useful if many problems share a table or a gap.
enum class EqualArrays { repeated, shared };

/// Adds arrays to a message: as raw little-endian frames, or as plain (nested) lists. Throws NotFinite for numbers that
/// messages cannot contain.
class ArrayWriter {
   public:
    explicit ArrayWriter(ArrayEncoding encoding, EqualArrays equal = EqualArrays::repeated)
        : encoding_(encoding), equal_(equal) {}
    /// Returns the JSON of the array; `shape` is in C order, and its product is the number of values.
    nlohmann::json write(std::span<const double> values, std::vector<std::size_t> shape);
    /// Creates a frame from the array without reading it; the caller guarantees that it is finite.
    nlohmann::json write_finite(UnsetArray&& values, std::vector<std::size_t> shape);
    nlohmann::json write(std::span<const unsigned char> values, std::vector<std::size_t> shape);
    Frames take_frames() { return std::move(frames_); }

   private:
    nlohmann::json add_frame(Frame frame, const char* dtype, std::vector<std::size_t> shape);
    std::size_t number_of(Frame frame);

    ArrayEncoding encoding_;
    EqualArrays equal_;
    Frames frames_;
    std::unordered_multimap<std::size_t, std::size_t>
        frames_by_hash_;  ///< numbers of frames, when equal ones are shared
};

/// Returns the array of `json`: a (nested) list of numbers or {"$array": {frame, dtype "<f8", shape}}. Checks shape,
/// frame, bytes and that every value is finite; throws StatusError naming `field` (ARRAY_INVALID).
std::vector<double> read_array(const nlohmann::json& json, const Frames& frames, const std::vector<std::size_t>& shape,
                               const std::string& field);
UnsetArray read_unset_array(const nlohmann::json& json, const Frames& frames, const std::vector<std::size_t>& shape,
                            const std::string& field);
/// Reads an array of dtype "|u1".
std::vector<unsigned char> read_byte_array(const nlohmann::json& json, const Frames& frames,
                                           const std::vector<std::size_t>& shape, const std::string& field);

/// Appends a text made by `dump`, with the frame numbers of its arrays increased by `count`, to follow those of another
/// message.
void append_moved(std::string& text, std::string_view message, std::size_t count);

/// Returns which of `count` frames the arrays of `params` refer to.
std::vector<bool> frames_used(const nlohmann::json& params, std::size_t count);

/// Throws StatusError (ARRAY_INVALID) if a frame has no reference {"$array": ...} anywhere in `params`.
void check_frames_used(const nlohmann::json& params, const Frames& frames);

}  // namespace contactd::proto

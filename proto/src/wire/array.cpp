#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <type_traits>

#include "contactd/finite.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "schema/shown.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using Shape = std::vector<std::size_t>;

static_assert(std::endian::native == std::endian::little, "array frames are copied as they lie in memory");

template <class T>
constexpr const char* dtype = std::is_same_v<T, double> ? "<f8" : "|u1";

std::string text_of(const Shape& shape) {
    std::string text;
    for (const std::size_t n : shape) text += (text.empty() ? "" : ", ") + std::to_string(n);
    return "[" + text + "]";
}

/// Returns the product of a shape, or the largest size_t if it does not fit.
std::size_t count_of(const Shape& shape) {
    std::size_t count = 1;
    for (const std::size_t n : shape) {
        if (n != 0 && count > std::numeric_limits<std::size_t>::max() / 16 / n)
            return std::numeric_limits<std::size_t>::max();
        count *= n;
    }
    return count;
}

Shape index_of(std::size_t at, const Shape& shape) {
    Shape index(shape.size());
    for (std::size_t d = shape.size(); d-- > 0; at /= shape[d]) index[d] = at % shape[d];
    return index;
}

template <class T>
json nested_list(std::span<const T> values, std::span<const std::size_t> shape) {
    if (shape.size() == 1) return json(std::vector<T>(values.begin(), values.end()));
    json list = json::array();
    const std::size_t stride = shape[0] == 0 ? 0 : values.size() / shape[0];
    for (std::size_t i = 0; i < shape[0]; ++i)
        list.push_back(nested_list<T>(values.subspan(i * stride, stride), shape.subspan(1)));
    return list;
}

std::size_t first_infinite(std::span<const double> values) {
    const auto at = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
    return static_cast<std::size_t>(at - values.begin());
}

void check_count(std::size_t count, const Shape& shape) {
    if (shape.empty() || count_of(shape) != count)
        throw Error("An array of " + std::to_string(count) + " values cannot have the shape " + text_of(shape) + ".");
}

template <class T>
void check_array(std::span<const T> values, const Shape& shape) {
    check_count(values.size(), shape);
    if constexpr (std::is_same_v<T, double>) {
        if (all_finite(values)) return;
        throw NotFinite("An array to be sent is not finite at " + text_of(index_of(first_infinite(values), shape)) +
                        ".");
    }
}

template <class T>
Frame frame_of(std::span<const T> values) {
    return std::string(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

[[noreturn]] void invalid(const std::string& field, const std::string& problem) {
    throw invalid_field(field, problem, reason::array_invalid);
}

/// Reads one array of a message.
template <class T, class Values = std::vector<T>>
class ArrayReader {
   public:
    ArrayReader(const Frames& frames, const Shape& shape, const std::string& field)
        : frames_(frames), shape_(shape), field_(field) {}

    Values read(const json& source) {
        if (source.is_array()) {
            index_.clear();
            append(source);
        } else if (source.is_object() && source.contains("$array")) {
            copy(source["$array"]);
        } else {
            invalid(field_, "is " + shown(source) + "; it must be a list of numbers or {\"$array\": ...}");
        }
        check_finite();
        return std::move(values_);
    }

   private:
    void append(const json& node) {
        const std::size_t depth = index_.size();
        if (depth == shape_.size()) return append_number(node);
        if (!node.is_array())
            invalid(field_, "contains " + shown(node) + where() + "; it must be a list of " +
                                std::to_string(shape_[depth]) + ", because the shape is " + text_of(shape_));
        if (node.size() != shape_[depth])
            invalid(field_, "has " + std::to_string(node.size()) + " values" + where() + "; it must have " +
                                std::to_string(shape_[depth]) + " there, as the shape is " + text_of(shape_));
        index_.push_back(0);
        for (const json& entry : node) {
            append(entry);
            ++index_.back();
        }
        index_.pop_back();
    }

    /// Describes the position only in errors: creating texts for millions of positions would take longer than reading
    /// the numbers.
    std::string where() const { return index_.empty() ? "" : " at " + text_of(index_); }

    void append_number(const json& node) {
        if constexpr (std::is_same_v<T, double>) {
            if (!node.is_number()) invalid(field_, "contains " + shown(node) + where() + "; it must be a number");
            values_.push_back(node.get<double>());
        } else {
            if (!node.is_number_integer() || node < 0 || node > 255)
                invalid(field_, "contains " + shown(node) + where() + "; it must be an integer from 0 to 255");
            values_.push_back(node.get<T>());
        }
    }

    const json& part(const json& reference, const char* key) const {
        const auto at = reference.find(key);
        if (at == reference.end()) invalid(field_, std::string("lacks ") + key + " in its $array");
        return *at;
    }

    void copy(const json& reference) {
        if (!reference.is_object())
            invalid(field_, "has a $array that is not an object; it must contain frame, dtype and shape");
        const std::string_view bytes = frame(part(reference, "frame"));
        const json& type = part(reference, "dtype");
        if (type != dtype<T>)
            invalid(field_, "has dtype " + shown(type) + "; it must be \"" + std::string(dtype<T>) + "\"");
        check_shape(part(reference, "shape"));
        const std::size_t count = count_of(shape_);
        if (bytes.size() % sizeof(T) != 0 || bytes.size() / sizeof(T) != count)
            invalid(field_, "has a frame of " + std::to_string(bytes.size()) + " bytes; the shape " + text_of(shape_) +
                                " of " + dtype<T> + " needs " + std::to_string(count) + " * " +
                                std::to_string(sizeof(T)));
        values_.resize(count);
        if (count > 0) std::memcpy(values_.data(), bytes.data(), bytes.size());
    }

    std::string_view frame(const json& number) const {
        const bool integer = number.is_number_integer();
        if (integer && number >= 1 && number <= frames_.size()) return frames_[number.get<std::size_t>() - 1].bytes();
        const std::string behind = frames_.empty()       ? "no frame follows the envelope"
                                   : frames_.size() == 1 ? "there is only frame 1"
                                                         : "there are frames 1 to " + std::to_string(frames_.size());
        invalid(field_, "refers to frame " + shown(number) + "; " + behind);
    }

    void check_shape(const json& given) const {
        bool same = given.is_array() && given.size() == shape_.size();
        for (std::size_t d = 0; same && d < shape_.size(); ++d)
            same = given[d].is_number_integer() && given[d] == shape_[d];
        if (!same)
            invalid(field_, "has shape " + (given.is_array() ? shortened(dump(given)) : shown(given)) +
                                "; it must be " + text_of(shape_));
    }

    void check_finite() const {
        if constexpr (std::is_same_v<T, double>) {
            if (all_finite(values_)) return;
            const std::size_t at = first_infinite(values_);
            invalid(field_, "contains " + std::string(std::isnan(values_[at]) ? "NaN" : "an infinity") + " at " +
                                text_of(index_of(at, shape_)) + "; every value must be finite");
        }
    }

    const Frames& frames_;
    const Shape& shape_;
    const std::string& field_;
    Shape index_;
    Values values_;
};

void collect_frames(const json& node, std::vector<bool>& used) {
    if (!node.is_structured()) return;
    if (node.is_object()) {
        if (const auto reference = node.find("$array"); reference != node.end() && reference->is_object())
            if (const auto frame = reference->find("frame"); frame != reference->end() && frame->is_number_integer())
                if (*frame >= 1 && *frame <= used.size()) used[frame->get<std::size_t>() - 1] = true;
    }
    for (const json& child : node) collect_frames(child, used);
}

}  // namespace

json ArrayWriter::write(std::span<const double> values, Shape shape) {
    check_array(values, shape);
    if (encoding_ == ArrayEncoding::list) return nested_list<double>(values, shape);
    return add_frame(frame_of(values), dtype<double>, std::move(shape));
}

json ArrayWriter::write_finite(UnsetArray&& values, Shape shape) {
    if (encoding_ == ArrayEncoding::list) return write(std::span<const double>(values), std::move(shape));
    check_count(values.size(), shape);
    return add_frame(Frame(std::move(values)), dtype<double>, std::move(shape));
}

json ArrayWriter::write(std::span<const unsigned char> values, Shape shape) {
    check_array(values, shape);
    if (encoding_ == ArrayEncoding::list) return nested_list<unsigned char>(values, shape);
    return add_frame(frame_of(values), dtype<unsigned char>, std::move(shape));
}

json ArrayWriter::add_frame(Frame frame, const char* type, Shape shape) {
    const std::size_t number = number_of(std::move(frame));
    return object({{"$array", object({{"frame", number}, {"dtype", type}, {"shape", std::move(shape)}})}});
}

std::size_t ArrayWriter::number_of(Frame frame) {
    if (equal_ == EqualArrays::shared) {
        const std::size_t hash = std::hash<std::string_view>()(frame.bytes());
        const auto [first, last] = frames_by_hash_.equal_range(hash);
        for (auto at = first; at != last; ++at)
            if (frames_[at->second - 1] == frame) return at->second;
        frames_by_hash_.emplace(hash, frames_.size() + 1);
    }
    frames_.push_back(std::move(frame));
    return frames_.size();
}

std::vector<double> read_array(const json& source, const Frames& frames, const Shape& shape, const std::string& field) {
    return ArrayReader<double>(frames, shape, field).read(source);
}

UnsetArray read_unset_array(const json& source, const Frames& frames, const Shape& shape, const std::string& field) {
    return ArrayReader<double, UnsetArray>(frames, shape, field).read(source);
}

std::vector<unsigned char> read_byte_array(const json& source, const Frames& frames, const Shape& shape,
                                           const std::string& field) {
    return ArrayReader<unsigned char>(frames, shape, field).read(source);
}

void append_moved(std::string& text, std::string_view message, std::size_t count) {
    // Quotes within a JSON text are escaped by a backslash, so this pattern is only found as a name.
    constexpr std::string_view reference = "\"$array\":{", number = "\"frame\":";
    for (std::size_t at = count == 0 ? message.npos : message.find(reference); at != message.npos;
         at = message.find(reference)) {
        const std::size_t begin = message.find(number, at) + number.size();
        const std::size_t end = message.find_first_not_of("0123456789", begin);
        text += message.substr(0, begin);
        text += std::to_string(std::stoull(std::string(message.substr(begin, end - begin))) + count);
        message.remove_prefix(end);
    }
    text += message;
}

std::vector<bool> frames_used(const json& params, std::size_t count) {
    std::vector<bool> used(count);
    collect_frames(params, used);
    return used;
}

void check_frames_used(const json& params, const Frames& frames) {
    const std::vector<bool> used = frames_used(params, frames.size());
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i])
            invalid("frame " + std::to_string(i + 1),
                    "is not used by any array; send only frames that params refer to");
}

}  // namespace contactd::proto

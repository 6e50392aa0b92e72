#include "serialized.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "digest.hpp"

namespace contactd::fmu {
namespace {

static_assert(std::endian::native == std::endian::little, "states are little-endian");

class Writer {
   public:
    template <class Number>
    void put(Number number) {
        put(std::as_bytes(std::span(&number, 1)));
    }
    void put(const std::vector<double>& numbers) {
        put(std::uint64_t{numbers.size()});
        put(std::as_bytes(std::span(numbers)));
    }
    void put(const std::string& text) {
        put(std::uint64_t{text.size()});
        put(std::as_bytes(std::span(text)));
    }
    std::vector<std::byte> bytes;

   private:
    void put(std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }
};

Failure damaged() {
    return Failure(
        "These bytes are not a state of this FMU: they are damaged, truncated, or of another version or kind.");
}

class Reader {
   public:
    explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class Number>
    Number number() {
        Number value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    std::vector<double> numbers() {
        const auto count = number<std::uint64_t>();
        if (count > left_.size() / sizeof(double)) throw damaged();
        std::vector<double> values(count);
        const auto from = take(count * sizeof(double));
        if (count > 0) std::memcpy(values.data(), from.data(), from.size());
        return values;
    }
    std::string text() {
        const auto from = take(number<std::uint64_t>());
        return {reinterpret_cast<const char*>(from.data()), from.size()};
    }
    bool at_end() const { return left_.empty(); }

   private:
    std::span<const std::byte> take(std::uint64_t size) {
        if (size > left_.size()) throw damaged();
        const auto taken = left_.first(size);
        left_ = left_.subspan(size);
        return taken;
    }
    std::span<const std::byte> left_;
};

std::uint64_t digest_of(std::span<const std::byte> bytes) {
    Digest digest;
    digest.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return digest.value();
}

}  // namespace

std::vector<std::byte> serialized(const Kind& kind, const State& state) {
    Writer writer;
    writer.put(token_of(kind));
    writer.put(static_cast<std::int32_t>(state.phase));
    writer.put(state.values.numbers);
    for (const std::string& text : state.values.texts) writer.put(text);
    writer.put(state.carried.solved);
    for (const std::vector<double>& array : state.carried.history) writer.put(array);
    writer.put(digest_of(writer.bytes));
    return std::move(writer.bytes);
}

void put_serialized(const Kind& kind, const State& state, void* bytes, std::size_t size) {
    const std::vector<std::byte> all = serialized(kind, state);
    if (bytes == nullptr || size < all.size())
        throw Failure("The state takes " + std::to_string(all.size()) + " bytes; there is room for " +
                      std::to_string(bytes ? size : 0) + ".");
    std::memcpy(bytes, all.data(), all.size());
}

std::unique_ptr<State> deserialized(const Kind& kind, std::span<const std::byte> bytes) {
    constexpr std::size_t digest = sizeof(std::uint64_t);
    if (bytes.size() < digest ||
        Reader(bytes.last(digest)).number<std::uint64_t>() != digest_of(bytes.first(bytes.size() - digest)))
        throw damaged();
    Reader reader(bytes.first(bytes.size() - digest));
    if (reader.text() != token_of(kind)) throw damaged();
    const auto phase = reader.number<std::int32_t>();
    if (phase < 0 || phase > static_cast<std::int32_t>(Phase::terminated)) throw damaged();
    auto state = std::make_unique<State>(State{static_cast<Phase>(phase), Values(kind.variables), {}});
    state->values.numbers = reader.numbers();
    if (state->values.numbers.size() != kind.variables.size()) throw damaged();
    for (std::string& text : state->values.texts) text = reader.text();
    state->carried.solved = reader.numbers();
    for (std::vector<double>& array : state->carried.history) array = reader.numbers();
    if (!reader.at_end()) throw damaged();
    return state;
}

}  // namespace contactd::fmu

// Mutates the text of a message as JSON: numbers become similar, different, or those of another place; members and
// elements are removed, duplicated or exchanged. In every other input, libFuzzer mutates the bytes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "input.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using nlohmann::json;

class Mutation {
   public:
    Mutation(json& document, unsigned seed) : dice_(seed) { collect(document); }

    void apply() {
        for (std::size_t more = 1 + below(3); more > 0 && !nodes_.empty(); --more) {
            json& node = any();
            if (node.is_number())
                change_number(node);
            else if (node.is_boolean())
                node = !node.get<bool>();
            else if (node.is_array())
                change_list(node);
            else if (node.is_object() && below(8) == 0)
                leave_out_of(node);
        }
    }

   private:
    std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(dice_); }
    double uniform(double from, double to) { return std::uniform_real_distribution(from, to)(dice_); }

    void collect(json& node) {
        nodes_.push_back(&node);
        if (node.is_structured())
            for (json& child : node) collect(child);
    }

    json& any() { return *nodes_[below(nodes_.size())]; }

    void change_number(json& node) {
        constexpr std::array special{0.0, 1.0, -1.0, 0.5, 1e-9, 1e9, 1e-300, 1e300};
        const double value = node.get<double>();
        switch (below(7)) {
            case 0:
                node = value * uniform(0.9, 1.1);
                break;
            case 1:
                node = value * std::exp2(uniform(-20, 20));
                break;
            case 2:
                node = value + uniform(-1, 1) * std::pow(10, uniform(-12, 1));
                break;
            case 3:
                node = -value;
                break;
            case 4:
                node = special[below(special.size())];
                break;
            case 5:
                node = static_cast<std::int64_t>(below(20));
                break;
            default:
                if (const json other = any(); other.is_number()) node = other;
        }
    }

    // Collected nodes below the node no longer exist afterwards.

    void leave_out_of(json& object) {
        if (object.empty()) return;
        object.erase(std::next(object.begin(), static_cast<std::ptrdiff_t>(below(object.size()))));
        nodes_.clear();
    }

    void change_list(json& node) {
        if (node.empty()) return;
        const auto at = static_cast<std::ptrdiff_t>(below(node.size()));
        const auto other = static_cast<std::ptrdiff_t>(below(node.size()));
        json list = node;
        switch (below(4)) {
            case 0:
                list.erase(list.begin() + at);
                break;
            case 1:
                list.insert(list.begin() + other, json(list[static_cast<std::size_t>(at)]));
                break;
            case 2:
                std::swap(list[static_cast<std::size_t>(at)], list[static_cast<std::size_t>(other)]);
                break;
            default:
                std::rotate(list.begin(), list.begin() + at, list.end());
        }
        node = std::move(list);
        nodes_.clear();
    }

    std::minstd_rand dice_;
    std::vector<json*> nodes_;
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
    const std::string_view bytes = fuzz::bytes_of(data, size);
    const std::string_view text = bytes.substr(0, bytes.find('\0'));
    json document = json::parse(text, nullptr, false);
    if (document.is_discarded() || seed % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
    const std::string frames(bytes.substr(text.size()));
    Mutation(document, seed).apply();
    const std::string mutated = document.dump(-1, ' ', false, json::error_handler_t::replace) + frames;
    if (mutated.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    std::memcpy(data, mutated.data(), mutated.size());
    return mutated.size();
}

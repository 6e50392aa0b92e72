#include "section_numbers.hpp"

#include <cstddef>
#include <variant>

#include "contactd/fields/profile_spec.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/section_fields.hpp"

namespace contactd {
namespace {

class Writer {
   public:
    std::vector<double> numbers;

    template <class Value>
    void add(const Value& value) {
        if constexpr (std::is_enum_v<Value> || std::is_arithmetic_v<Value>)
            numbers.push_back(static_cast<double>(value));
        else
            for_each_named_member(value, [this](const char*, const auto& field) { add(field); });
    }
    template <class Value>
    void add(const std::vector<Value>& list) {
        add(list.size());
        for (const Value& value : list) add(value);
    }
    template <class... Alternatives>
    void add(const std::variant<Alternatives...>& value) {
        add(value.index());
        std::visit([this](const auto& alternative) { add(alternative); }, value);
    }
};

class Reader {
   public:
    explicit Reader(const std::vector<double>& numbers) : numbers_(numbers) {}

    bool at_end() const { return next_ == numbers_.size(); }

    template <class Value>
    void get(Value& value) {
        if constexpr (std::is_enum_v<Value>)
            value = static_cast<Value>(count(enum_words<Value>.size()));
        else if constexpr (std::is_same_v<Value, std::size_t>)
            value = count(numbers_.size());
        else if constexpr (std::is_same_v<Value, bool>)
            value = count(2) != 0;
        else if constexpr (std::is_arithmetic_v<Value>)
            value = number();
        else
            for_each_named_member(value, [this](const char*, auto& field) { get(field); });
    }
    template <class Value>
    void get(std::vector<Value>& list) {
        list.resize(count(numbers_.size()));
        for (Value& value : list) get(value);
    }
    template <class... Alternatives>
    void get(std::variant<Alternatives...>& value) {
        const std::size_t which = count(sizeof...(Alternatives));
        std::size_t index = 0;
        ((index++ == which ? get(value.template emplace<Alternatives>()) : void()), ...);
    }

   private:
    double number() {
        if (next_ == numbers_.size()) throw DamagedTable("The section of the file ends too early.");
        return numbers_[next_++];
    }
    /// Reads a count, which must be below `end`.
    std::size_t count(std::size_t end) {
        const double value = number();
        if (!(value >= 0 && value < static_cast<double>(end)))
            throw DamagedTable("The section of the file contains an invalid number.");
        return static_cast<std::size_t>(value);
    }

    const std::vector<double>& numbers_;
    std::size_t next_ = 0;
};

}  // namespace

std::vector<double> numbers_of(const Section& section) {
    Writer writer;
    writer.add(section);
    return writer.numbers;
}

Section section_from(const std::vector<double>& numbers) {
    Reader reader(numbers);
    Section section;
    reader.get(section);
    if (!reader.at_end()) throw DamagedTable("The section of the file contains too many numbers.");
    return section;
}

}  // namespace contactd

// Holds the values of an instance's variables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "variable.hpp"

namespace contactd::fmu {

/// Holds by value reference: numbers of all variables except texts (booleans 0 or 1, enumerations the index of their
/// word).
struct Values {
    explicit Values(std::span<const Variable> list) : numbers(list.size()), texts(list.size()) {
        for (std::size_t at = 0; at < list.size(); ++at) {
            numbers[at] = list[at].start;
            texts[at] = list[at].text;
        }
    }

    double operator[](std::size_t at) const { return numbers[at]; }
    double& operator[](std::size_t at) { return numbers[at]; }
    int whole(std::size_t at) const { return static_cast<int>(numbers[at]); }
    bool is(std::size_t at) const { return numbers[at] != 0; }
    const std::string& text(std::size_t at) const { return texts[at]; }

    std::vector<double> numbers;
    std::vector<std::string> texts;
};

}  // namespace contactd::fmu

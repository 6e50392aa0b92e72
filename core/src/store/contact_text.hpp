// What writer and reader of CONTACT's text have in common.
#pragma once

#include <array>

#include "contactd/ic_table.hpp"

namespace contactd::contact_text {

/// Order of the coordinate directions: 3, 1, 2 for z (normal), x, y.
inline constexpr int order_zxy = 312;

struct Column {
    Axis displacement;
    Axis load;
};
inline constexpr std::array<Column, 9> columns{{{Axis::z, Axis::z},
                                                {Axis::z, Axis::x},
                                                {Axis::z, Axis::y},
                                                {Axis::x, Axis::z},
                                                {Axis::x, Axis::x},
                                                {Axis::x, Axis::y},
                                                {Axis::y, Axis::z},
                                                {Axis::y, Axis::x},
                                                {Axis::y, Axis::y}}};

/// Stand before the y offset, its y and the modulus in the comments of our own texts.
inline constexpr const char* offset_mark = "offset iy = ";
inline constexpr const char* y_mark = ", y = ";
inline constexpr const char* modulus_mark = "times G = ";

}  // namespace contactd::contact_text

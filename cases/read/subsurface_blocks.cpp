#include <algorithm>
#include <string>

#include "steps.hpp"

namespace contactd::contact_files {
namespace {

constexpr std::size_t most_blocks = 10;
constexpr int most_points = 10000;  // largest number of points of a block along one axis

int count_in(Reading& reading, const ByName<ContactValue>& group, const char* name) {
    const int count = std::get<int>(group.at(name));
    if (count < 1 || count > most_points)
        reading.lines.fail(reading.lines.words().front(), "has " + std::string(name) + " = " + std::to_string(count) +
                                                              "; a block must have 1 to 10000 points along an axis");
    return count;
}

/// Reads the first number, the step and the last number of columns or rows.
ContactNumbers range_of(Reading& reading, const std::string& axis) {
    const ByName<ContactValue> group = read_values(reading, "I" + axis + "L# I" + axis + "INC# I" + axis + "H#");
    const auto value = [&](const char* end) { return std::get<int>(group.at("I" + axis + end)); };
    const int first = value("L"), step = value("INC"), last = value("H");
    if (step < 1 || last < first || (last - static_cast<long long>(first)) / step >= most_points)
        reading.lines.fail(reading.lines.words().front(),
                           "has elements " + std::to_string(first) + " to " + std::to_string(last) + " in steps of " +
                               std::to_string(step) + "; the numbers must increase, and there may be at most 10000");
    std::vector<double> numbers;
    for (long long i = first; i <= last; i += step) numbers.push_back(static_cast<double>(i));
    return shared(std::move(numbers));
}

ContactNumbers list_of(Reading& reading, const std::string& what, int count, std::string_view kinds = " ") {
    std::vector<double> numbers = read_array(reading, what, count, kinds);
    std::ranges::sort(numbers);
    return shared(std::move(numbers));
}

ContactNumbers depths_in_steps(Reading& reading) {
    const ByName<ContactValue> group = read_values(reading, "NZ# ZL DZ");
    const int count = count_in(reading, group, "NZ");
    std::vector<double> depths;
    for (int i = 0; i < count; ++i)
        depths.push_back(std::get<double>(group.at("ZL")) + i * std::get<double>(group.at("DZ")));
    std::ranges::sort(depths);
    return shared(std::move(depths));
}

/// Reads a block. Kinds 1 to 3 have equidistant depths, kinds 5 to 7 are the same with a list of depths, and kind 9 has
/// lists of all coordinates.
ByName<ContactValue> read_block(Reading& reading, int kind) {
    ByName<ContactValue> block{{"ISUBS", kind}};
    if (kind == 9) {
        const ByName<ContactValue> counts = read_values(reading, "NX# NY# NZ#");
        for (const char* axis : {"X", "Y", "Z"}) count_in(reading, counts, ("N" + std::string(axis)).c_str());
        for (const std::string axis : {"X", "Y", "Z"})
            block[axis] = list_of(reading, "the points' " + axis, std::get<int>(counts.at("N" + axis)));
        return block;
    }
    if (kind % 4 == 2) {
        block["IX"] = range_of(reading, "X");
        block["IY"] = range_of(reading, "Y");
    } else if (kind % 4 == 3) {
        const ByName<ContactValue> counts = read_values(reading, "NX# NY#");
        const int columns = count_in(reading, counts, "NX"), rows = count_in(reading, counts, "NY");
        block["IX"] = list_of(reading, "the columns of elements", columns, "#");
        block["IY"] = list_of(reading, "the rows of elements", rows, "#");
    }
    if (kind < 4) {
        block["Z"] = depths_in_steps(reading);
    } else {
        const int count = count_in(reading, read_values(reading, "NZ#"), "NZ");
        block["Z"] = list_of(reading, "the points' Z", count);
    }
    return block;
}

}  // namespace

void read_subsurface(Reading& reading) {
    if (reading.digit("S") < 2) return;
    read_group(reading, "SUBS_A# SUBS_O#");
    if (reading.digit("S") < 3) return;
    ContactBlocks blocks;
    while (true) {
        const int kind = std::get<int>(read_values(reading, "ISUBS#").at("ISUBS"));
        if (kind == 0) break;
        if (kind < 0 || kind == 4 || kind == 8 || kind > 9)
            reading.lines.fail(reading.lines.words().front(),
                               "has ISUBS = " + std::to_string(kind) +
                                   "; a block of points must be 1, 2, 3, 5, 6, 7 or 9, and 0 ends the blocks");
        if (blocks.size() == most_blocks)
            reading.lines.fail(
                reading.lines.words().front(),
                "begins an eleventh block of points; a case may have at most ten, followed by ISUBS = 0");
        blocks.push_back(read_block(reading, kind));
    }
    reading.result.subsurface = std::make_shared<const ContactBlocks>(std::move(blocks));
    reading.result.read.push_back("subsurface");
}

}  // namespace contactd::contact_files

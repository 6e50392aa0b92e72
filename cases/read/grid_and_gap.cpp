// Reads the potential contact and the undeformed distance of module 3.
#include <string>

#include "steps.hpp"

namespace contactd::contact_files {
namespace {

constexpr const char* hertz_names = "A1 B1 AOB AA BB BNEG BPOS SCALE";
constexpr const char* rectangle_names = "XL YL DX DY XH YH XC1 YC1 XCM YCM";
constexpr const char* base_names = "IBASE IPLAN B1 B2 B3 B4 B5 B6 B7 B8 XM RM Y1 DY1 HEIGHTS GAP";
constexpr const char* plan_names =
    "P1 P2 P3 P4 P5 P6 XL1 XH1 YL1 YH1 XL2 XH2 YL2 YH2 NPATCH PATCH_LIMITS PATCH_FACTORS";
constexpr int most_plan_patches = 100;

std::string potential_contact(int kind) {
    switch (kind) {
        case -6:
            return "AA BNEG BPOS SCALE";
        case -5:
        case -3:
            return "AA BB SCALE";
        case -4:
            return "A1 BB SCALE";
        case -2:
            return "A1 AOB SCALE";
        case -1:
            return "A1 B1 SCALE";
        case 1:
            return "XL YL DX DY";
        case 2:
            return "XL YL XH YH";
        case 3:
            return "XC1 YC1 DX DY";
        case 4:
            return "XC1 YC1 XCM YCM";
        default:
            return {};
    }
}

[[noreturn]] void fail_first_word(const Reading& reading, const std::string& problem) {
    reading.lines.fail(reading.lines.words().front(), problem);
}

void read_base(Reading& reading, int base) {
    switch (base) {
        case 1:
            return read_group(reading, "B1 B2 B3 B4 B5 B6");
        case 2: {
            const ByName<ContactValue> head = read_values(reading, "NN# XM RM Y1 DY1");
            const int heights = std::get<int>(head.at("NN"));
            if (heights < 1)
                fail_first_word(reading, "has NN = " + std::to_string(heights) +
                                             "; the number of heights of the profile must be positive");
            for (const char* name : {"XM", "RM", "Y1", "DY1"}) reading.take(name, head.at(name));
            return reading.take("HEIGHTS", shared(read_array(reading, "the heights of the profile", heights)));
        }
        case 3:
            return read_group(reading, "B1 B2 B3 B4 B5 B6 B7 B8");
        case 9: {
            const auto elements = static_cast<std::size_t>(reading.integer("MX")) * reading.integer("MY");
            if (elements == 0)
                reading.lines.fail_line(
                    "requires MX and MY before the undeformed distance of each element (IBASE = 9)");
            return reading.take("GAP", shared(read_array(reading, "the undeformed distance", elements)));
        }
        default:
            fail_first_word(reading, "has IBASE = " + std::to_string(base) +
                                         "; the undeformed distance must be 1 (quadratic), 2 (a profile), 3 (two "
                                         "sines) or 9 (a value for each element)");
    }
}

/// Reads the limits of patches, and the factors between each two of them.
void read_plan_of_patches(Reading& reading) {
    read_group(reading, "NPATCH#");
    const int patches = reading.integer("NPATCH");
    if (patches < 1 || patches > most_plan_patches)
        fail_first_word(reading, "has NPATCH = " + std::to_string(patches) + "; there must be 1 to 100 patches");
    std::vector<double> limits;
    for (int i = 0; i < patches; ++i) {
        const ByName<ContactValue> box = read_values(reading, "XL XH YL YH");
        for (const char* name : {"XL", "XH", "YL", "YH"}) limits.push_back(std::get<double>(box.at(name)));
    }
    reading.take("PATCH_LIMITS", shared(std::move(limits)));
    const auto pairs = static_cast<std::size_t>(patches) * (patches - 1) / 2;
    reading.take("PATCH_FACTORS", shared(read_array(reading, "the factors between patches", pairs)));
}

void read_plan(Reading& reading, int plan) {
    switch (plan) {
        case 1:
            return;
        case 2:
            return read_group(reading, "P1 P2 P3 P4 P5 P6");
        case 3:
            return read_group(reading, "XL1 XH1 YL1 YH1 XL2 XH2 YL2 YH2");
        case 4:
            return read_plan_of_patches(reading);
        default:
            fail_first_word(
                reading, "has IPLAN = " + std::to_string(plan) +
                             "; the planform must be 1 (all elements), 2 (a conic), 3 (two rectangles) or 4 (patches)");
    }
}

}  // namespace

void read_grid(Reading& reading) {
    if (reading.digit("D") != 2) return;
    const int kept = reading.integer("IPOTCN");
    read_group(reading, "IPOTCN#");
    const int kind = reading.integer("IPOTCN");
    const std::string group = potential_contact(kind);
    if (group.empty())
        fail_first_word(reading,
                        "has IPOTCN = " + std::to_string(kind) +
                            "; the potential contact area must be -6 to -1 (Hertzian) or 1 to 4 (a rectangle)");
    reading.forget(rectangle_names);
    if (kept < 0) reading.forget(hertz_names);
    if (kind < 0) {
        reading.forget(base_names);
        reading.forget(plan_names);
    }
    read_group(reading, "MX# MY# " + group);
    if (reading.integer("MX") < 1 || reading.integer("MY") < 1)
        fail_first_word(reading, "has MX = " + std::to_string(reading.integer("MX")) +
                                     ", MY = " + std::to_string(reading.integer("MY")) +
                                     "; both numbers of elements must be positive");
}

void read_gap(Reading& reading) {
    if (reading.digit("Z") < 2 || reading.integer("IPOTCN") <= 0) return;
    reading.forget(base_names);
    reading.forget(plan_names);
    read_group(reading, "IBASE# IPLAN#");
    const int plan = reading.integer("IPLAN");
    if (plan < 1 || plan > 4) read_plan(reading, plan);
    read_base(reading, reading.integer("IBASE"));
    read_plan(reading, plan);
}

}  // namespace contactd::contact_files

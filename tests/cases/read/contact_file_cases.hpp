// Provides small input files of CONTACT, one for each rule.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "contactd/read_contact_file.hpp"

namespace contactd::contact_file_cases {

/// Provides the parts of a case of module 3 that most rules concern: a ball on a plane, pressed down and shifted.
struct BasicCase {
    std::string module = "3 MODULE\n";
    std::string digits = "201100 P-B-T-N-F-S\n022020 L-D-C-M-Z-E\n000001 H-G-I-A-O-W-R\n";
    std::string solver = "100 30 5 1 1e-6 MAXGS, MAXIN, MAXNR, MAXOUT, EPS\n";
    std::string load = "1000. 0.004 0. 0.\n";
    std::string friction = "0.3 0.3\n";
    std::string rolling;
    std::string material = ".28 .28 82000. 82000.\n";
    std::string more;  ///< of the material
    std::string grid = "1\n4 3 -1. -.75 .5 .5\n";
    std::string gap = "1 1\n.001 0 .002 0 0 0\n";
    std::string rest;

    std::string text() const {
        return module + digits + solver + load + friction + rolling + material + more + grid + gap + rest;
    }
};

/// Provides a wheel on its rail that keeps no earlier values.
struct RailCase {
    std::string module = "1 MODULE\n";
    std::string digits = "1203100 C-P-B-T-N-F-S\n0022033 V-L-D-C-M-Z-E\n0000001 H-G-I-A-O-W-R\n";
    std::string solver = "100 30 5 1 1e-6\n";
    std::string friction = "0.3 0.3\n";
    std::string material = ".28 .28 82000. 82000.\n";
    std::string grid = "0.2 0.25 1. 90d 8. 4.\n";
    std::string track = "14. 0 1435. 0.025\n";
    std::string rail = "'rail.prr' 0 1. 0.\n";
    std::string deviation = "0. 0. 1.5d 0. 0. 0.\n";
    std::string wheelset = "1360. -70. 460.\n";
    std::string wheel = "'folder/wheel.prw' 1 1. 10. -1\n";
    std::string position = "0. 1.5 10000. 0.001 0. 0.\n";
    std::string velocity = "2000. 0. 0. 0. 0. -4.348\n";
    std::string rest;

    std::string text() const {
        return module + digits + solver + friction + material + grid + track + rail + deviation + wheelset + wheel +
               position + velocity + rest;
    }
};

inline const std::string end = "0 MODULE\n";

inline ContactFile read_all(const std::string& text) {
    return read_contact_file(text, "case.inp");
}

/// Returns the last case of a file without errors.
inline ContactCase last_of(const std::string& text) {
    const ContactFile file = read_all(text + end);
    for (const auto& problem : file.errors) throw std::runtime_error(problem);
    for (const auto& read : file.cases)
        for (const auto& problem : read.errors) throw std::runtime_error(problem);
    return file.cases.back();
}

inline double real(const ContactCase& read, const std::string& name) {
    return std::get<double>(read.values.at(name));
}

inline int integer(const ContactCase& read, const std::string& name) {
    return std::get<int>(read.values.at(name));
}

inline std::vector<double> numbers(const ContactValue& value) {
    return *std::get<ContactNumbers>(value);
}

inline std::vector<double> numbers(const ContactCase& read, const std::string& name) {
    return numbers(read.values.at(name));
}

}  // namespace contactd::contact_file_cases

// Reads cases for the drivers in C++: their words, the bodies and tables made by them, and the calls.
#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "contactd/client/client.hpp"
#include "contactd/contact.hpp"
#include "contactd/error.hpp"

namespace contactd {

using Words = std::vector<std::string>;

inline double number(const std::string& word) {
    return std::stod(word);
}

/// Creates a table whose xx, yy and zz decrease by a factor of four with each offset, without other components.
inline GivenIcs table(const Words& words) {
    const int nx = std::stoi(words[2]), ny = std::stoi(words[3]);
    GivenIcs given{IcTable(nx, ny), number(words[4]), number(words[5])};
    for (int axis = 0; axis < 3; ++axis)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                given.table(static_cast<Axis>(axis), static_cast<Axis>(axis), x, y) =
                    std::ldexp(number(words[6]), -2 * (x + y));
    return given;
}

/// Reads "body shape base_G base_nu", and "thickness G nu" of each layer.
inline Body layered(const Words& words) {
    Layers layers{{}, number(words[3]) == 0 ? Material::rigid() : Material{number(words[3]), number(words[4])}};
    for (std::size_t at = 5; at < words.size(); at += 3)
        layers.layers.push_back({number(words[at]), number(words[at + 1]), number(words[at + 2])});
    return Body::of(layers, words[2] == "bilinear" ? LoadShape::bilinear : LoadShape::constant);
}

/// Prints the line of a call: its case, its word, and its own output or the refusal.
template <class Call>
void print_call(const std::string& name, const std::string& word, const Call& call) {
    std::printf("%s %s", name.c_str(), word.c_str());
    try {
        call();
    } catch (const StatusError& error) {
        const Status& status = error.status();
        std::printf(" refused %d %s %s", static_cast<int>(status.code), status.reason.c_str(),
                    status.violations.empty() ? "" : status.violations[0].field.c_str());
    } catch (const InvalidArgument& error) {
        std::printf(" refused 3 FIELD_INVALID %s", error.field().c_str());
    }
    std::printf("\n");
}

/// Runs the cases in a file. A line that begins with one of `calls` calls the interface; the others describe the case.
template <class Case>
int run_cases(int arguments, char** argument, const std::set<std::string>& calls) {
    std::ifstream cases(arguments == 3 ? argument[2] : "");
    if (!cases) {
        std::cerr << "usage: " << argument[0] << " ENDPOINT CASES\n";
        return 2;
    }
    client::Client client(argument[1]);
    std::unique_ptr<Case> open;
    for (std::string line; std::getline(cases, line);) {
        std::istringstream text(line);
        Words words;
        for (std::string word; text >> word;) words.push_back(word);
        if (words.empty()) continue;
        if (words[0] == "case") {
            open.reset();
            open = std::make_unique<Case>(client, words[1]);
        } else if (calls.contains(words[0])) {
            open->call(words);
        } else {
            open->say(words);
        }
    }
    return 0;
}

}  // namespace contactd

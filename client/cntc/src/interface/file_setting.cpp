#include "file_setting.hpp"

#include <algorithm>

namespace contactd::cntc {

void pass_on() {
    int code = 0;
    const std::string sentence = contactd_cntc_last_error(&code);
    if (code != 0) throw Refused(code, sentence);
}

std::vector<double> FileSetting::reals(std::initializer_list<const char*> names) const {
    std::vector<double> values;
    for (const char* name : names) values.push_back(real(name));
    return values;
}

void FileSetting::flags(std::vector<std::array<int, 2>> own) {
    own.insert(own.end(), {{flag::previous, digit("P")},
                           {flag::bound, digit("B")},
                           {flag::tangential, digit("T")},
                           {flag::force, digit("F")},
                           {flag::influence, integer("INFLCF")},
                           {flag::material, digit("M")},
                           {flag::heat, digit("H")},
                           {flag::estimate, digit("I")}});
    std::vector<int> codes, values;
    for (const auto& [code, value] : own) {
        codes.push_back(code);
        values.push_back(value);
    }
    int count = static_cast<int>(codes.size());
    cntc_setflags(&ire_, &icp_, &count, codes.data(), values.data());
    pass_on();
}

/// INISLP stays in force when G names another solver. A file takes MAXOUT = 1 literally for dissimilar bodies.
void FileSetting::solvers() {
    int method = 0, ints = 4, count = 1;
    std::array bounds{integer("MAXGS"), integer("MAXIN"), integer("MAXNR"), integer("MAXOUT")};
    double eps = real("EPS");
    cntc_setsolverflags(&ire_, &icp_, &method, &ints, bounds.data(), &count, &eps);
    pass_on();
    for_each_settings(&ire_, &icp_, [&](Settings& settings) {
        settings.one_outer_iteration = bounds[3] == 1;
        if (read_.values.contains("INISLP")) settings.starts_in_slip = integer("INISLP") < 0;
    });
}

void FileSetting::material() {
    auto values = reals({"POISS1", "POISS2", "GG1", "GG2"});
    constexpr int viscoelastic = 1, fastsim = 3, layered = 4, fastrip = 5;
    const bool is_simplified = digit("M") == fastsim || digit("M") == fastrip;
    int method = is_simplified || digit("M") == viscoelastic || digit("M") == layered ? digit("M") : 0;
    if (method == viscoelastic) {
        const auto creep = reals({"FG1", "FG2", "TC1", "TC2"});
        values.insert(values.end(), creep.begin(), creep.end());
    }
    if (method == layered) {
        const auto layer = reals({"GG3", "LAYTHK", "TAU_C0", "K_TAU"});
        values.insert(values.end(), layer.begin(), layer.end());
    }
    if (is_simplified) {
        const auto slope = reals({"K0", "ALFA", "BETA"});
        values.insert(values.end(), slope.begin(), slope.end());
    }
    auto count = static_cast<int>(values.size());
    cntc_setmaterialparameters(&ire_, &icp_, &method, &count, values.data());
    pass_on();
    damping();
}

// M2 = 0 takes damping away, 1 keeps it, and 2 reads it.
void FileSetting::damping() {
    const auto digit = read_.digits.find("M2");
    if (digit == read_.digits.end()) return;
    constexpr int read = 2;
    std::vector<double> values(4);
    if (digit->second >= read) values = reals({"CDAMPN", "CDAMPT", "DFNMAX", "DFTMAX"});
    int method = 10 + std::min(digit->second, read), count = static_cast<int>(values.size());
    cntc_setmaterialparameters(&ire_, &icp_, &method, &count, values.data());
    pass_on();
}

void FileSetting::heat() {
    if (digit("H") == 0) return;
    auto values = reals({"BKTEMP1", "HEATCP1", "LAMBDA1", "DENS1", "BKTEMP2", "HEATCP2", "LAMBDA2", "DENS2"});
    constexpr int layered = 4;
    if (digit("M") == layered) values.push_back(real("BETAPL"));
    int method = 3, count = static_cast<int>(values.size());
    cntc_settemperaturedata(&ire_, &icp_, &method, &count, values.data());
    pass_on();
}

// Friction that varies has the number of its sets in front, and in front of each its angle or its place.
void FileSetting::friction() {
    const int law = integer("FRCLAW"), varies = integer("VARFRC");
    std::vector<double> values;
    if (varies > 0) values.push_back(static_cast<double>(read_.friction->size()));
    for (const auto& set : *read_.friction) {
        if (varies == 1) values.push_back(set.at("ALPHVF"));
        if (varies == 2) values.push_back(set.at("SVF"));
        if (law == 0)
            values.insert(values.end(), 2, set.at("FSTAT"));
        else if (law == 6)
            for (const char* name : {"FREF", "TREF", "DFHEAT", "DTHEAT"}) values.push_back(set.at(name));
        else
            for (const char* name : {"FKIN", "F1", "SABSH1", "F2", "SABSH2"}) values.push_back(set.at(name));
        if (law != 0) values.insert(values.end(), {real("MEMDST"), real("MEM_S0")});
        if (varies == 0) break;
    }
    int method = 10 * varies + law, count = static_cast<int>(values.size());
    cntc_setfrictionmethod(&ire_, &icp_, &method, &count, values.data());
    pass_on();
}

void FileSetting::blocks() {
    if (digit("S") == 0 || !read_.subsurface) return;
    int number = 0;
    for (const auto& block : *read_.subsurface) {
        ++number;
        const auto axis = [&](const char* name) {
            const auto found = block.find(name);
            return found == block.end() ? std::vector<double>(1) : *std::get<contactd::ContactNumbers>(found->second);
        };
        const bool has_elements = block.contains("IX"), has_places = block.contains("X");
        auto x = axis(has_elements ? "IX" : "X"), y = axis(has_elements ? "IY" : "Y"), z = axis("Z");
        int kind = has_places ? 9 : has_elements ? 7 : 5;
        int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size()), nz = static_cast<int>(z.size());
        subs_addblock(&ire_, &icp_, &number, &kind, &nx, &ny, &nz, x.data(), y.data(), z.data());
        pass_on();
    }
}

}  // namespace contactd::cntc

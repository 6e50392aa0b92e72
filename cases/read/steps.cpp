#include "steps.hpp"

#include <string>

namespace contactd::contact_files {

void read_steps(Reading& reading, std::span<const Step> steps) {
    for (const Step& step : steps) {
        if (step.read) {
            step.read(reading);
            continue;
        }
        const std::string group = step.group(reading);
        if (group.empty()) continue;
        reading.forget(step.replaces);
        read_group(reading, group);
    }
}

std::string solver_bounds(const Reading& reading) {
    if (reading.digit("G") == 1) return {};
    return std::string("MAXGS# MAXIN# MAXNR# MAXOUT# EPS") +
           (reading.result.module_number == 1 ? " {NPOT_MAX#=20000}" : "");
}

std::string solver_options(const Reading& reading) {
    switch (reading.digit("G")) {
        case 2:
        case 3:
            return "OMEGAH OMEGAS INISLP# OMGSLP";
        case 4:
            return "INISLP# OMGSLP";
        case 5:
            return "FDECAY BETATH KDOWFB# D_IFC D_LIN D_CNS D_SLP POW_S";
        default:
            return {};
    }
}

std::string elastic_constants(const Reading& reading) {
    return reading.digit("C") >= 2 ? "POISS1 POISS2 GG1 GG2" : "";
}

std::string thin_sheet(const Reading& reading) {
    return reading.digit("C") >= 2 && reading.digit("B") == 1 ? "FLXZ" : "";
}

std::string material_constants(const Reading& reading) {
    if (reading.digit("C") < 2) return {};
    switch (reading.digit("M")) {
        case 1:
            return "FG1 FG2 TC1 TC2";
        case 2:
            return "FLX K0 ALFA BETA";
        case 3:
        case 5:
            return "K0 ALFA BETA";
        case 4:
            return "GG3 LAYTHK TAU_C0 K_TAU";
        default:
            return {};
    }
}

std::string damping(const Reading& reading) {
    return reading.digit("M2") >= 2 ? "CDAMPN CDAMPT DFNMAX DFTMAX" : "";
}

std::string heat_of_first(const Reading& reading) {
    return reading.digit("H") == 3 ? "BKTEMP1 HEATCP1 LAMBDA1 DENS1" : "";
}

std::string heat_of_second(const Reading& reading) {
    return reading.digit("H") == 3 ? "BKTEMP2 HEATCP2 LAMBDA2 DENS2" : "";
}

std::string plastic_heat(const Reading& reading) {
    return reading.digit("H") == 3 && reading.digit("M") == 4 ? "BETAPL" : "";
}

}  // namespace contactd::contact_files

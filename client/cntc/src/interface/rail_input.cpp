// A case of an input file, set to a wheel on a rail.
#include <algorithm>
#include <filesystem>

#include "interface/file_setting.hpp"

namespace contactd::cntc {
namespace {

constexpr int roller = 4;  // and above: the configuration of a wheel on a roller

class RailSetting : private FileSetting {
   public:
    RailSetting(int ire, const FileCase& read, std::string folder)
        : FileSetting(ire, all_problems, read), folder_(std::move(folder)) {}

    void set() {
        const UnitsOfFile units(ire_, icp_);
        flags({{flag::configuration, digit("C1")},
               {flag::normal, digit("N")},
               {flag::discretisation, integer("DISCNS")},
               {flag::variant, read_.values.contains("VARIANT") ? integer("VARIANT") : 4},
               {flag::most_elements, integer("NPOT_MAX")}});
        solvers();
        material();
        heat();
        if (digit("T") != 0) friction();
        elements();
        profile("RFNAME", "RAIL_", 0);
        profile("WFNAME", "WHEEL_", 1);
        track();
        wheelset();
        load();
        blocks();
    }

   private:
    bool on_roller() const { return digit("C1") >= roller; }

    using Setter = void (*)(int*, int*, int*, double*);
    void call(Setter function, int kind, std::vector<double> values) {
        int count = static_cast<int>(values.size());
        function(&ire_, &kind, &count, values.data());
        pass_on();
    }

    void elements() {
        int option = -1;
        auto values = reals({"DX", "DS", "A_SEP", "D_SEP", "D_COMB", "D_TURN"});
        int count = static_cast<int>(values.size());
        cntc_setpotcontact(&ire_, &icp_, &option, &count, values.data());
        pass_on();
        double chi = 0, dq = real("DQREL");
        cntc_setrollingstepsize(&ire_, &icp_, &chi, &dq);
        pass_on();
    }

    void profile(const char* name, const std::string& prefix, int type) {
        const auto of = [&](const char* option) { return prefix + option; };
        std::string file = std::get<std::string>(read_.values.at(name));
        std::ranges::replace(file, '\\', '/');
        const std::string path = (std::filesystem::path(folder_) / file).string();
        const auto flag_of = [&](const char* option) { return integer(of(option).c_str()); };
        const auto value_of = [&](const char* option) { return real(of(option).c_str()); };
        std::array ints{type, 0, flag_of("MIRRORY"), flag_of("MIRRORZ"), 0, flag_of("ISMOOTH")};
        std::array values{value_of("SCALE"),    value_of("SMOOTH"),  value_of("MAXOMIT"), value_of("ZIGTHRS"),
                          value_of("KINKHIGH"), value_of("KINKLOW"), value_of("KINKWID")};
        int length = static_cast<int>(path.size()), nints = static_cast<int>(ints.size());
        int nreals = static_cast<int>(values.size());
        cntc_setprofileinputfname(&ire_, path.c_str(), &length, &nints, ints.data(), &nreals, values.data());
        pass_on();
    }

    void track() {
        const bool by_gauge = real("GAUGHT") > 0;
        call(cntc_settrackdimensions, 3,
             {real("GAUGHT"), by_gauge ? 0 : real("RAILY0"), by_gauge ? real("GAUGWD") : real("RAILZ0"),
              real_or_none("CANT"), real_or_none("NOMRADR"), real_or_none("CURV"), real_or_none("DYRAIL"),
              real_or_none("DZRAIL"), real_or_none("DROLLR"), real_or_none("VYRAIL"), real_or_none("VZRAIL"),
              real_or_none("VROLLR")});
        if (digit("F") == 3) call(cntc_settrackdimensions, 32, reals({"KYRAIL", "FYRAIL", "KZRAIL", "FZRAIL"}));
    }

    void wheelset() {
        constexpr int flexible = 5;
        call(cntc_setwheelsetdimensions, 3, reals({"FBDIST", "FBPOS", "NOMRADW"}));
        call(cntc_setwheelsetposition, 2,
             {real(on_roller() ? "X_WS" : "S_WS"), real("Y_WS"), real_or_none("Z_WS"), real("ROLL"), real("YAW"),
              real("PITCH")});
        call(cntc_setwheelsetvelocity, 2,
             {real(on_roller() ? "RPITCH" : "VS"), real("VY"), real("VZ"), real("VROLL"), real("VYAW"),
              real_or_none("VPITCH")});
        // Deviations of an earlier case stay in force, whatever the digit E says.
        std::vector<double> deviation;
        for (const char* name : {"DXWHL", "DYWHL", "DZWHL", "DROLLW", "DYAWW", "DPITCHW", "VXWHL", "VYWHL", "VZWHL",
                                 "VROLLW", "VYAWW", "VPITCHW"})
            deviation.push_back(real_or_none(name));
        call(cntc_setwheelsetflexibility, flexible, std::move(deviation));
    }

    void load() {
        if (digit("N") == 1) {
            double force = real("FZ");
            cntc_setverticalforce(&ire_, &force);
            pass_on();
        }
        if (digit("F") == 1) {
            double along = real("FX"), across = 0;
            cntc_settangentialforces(&ire_, &icp_, &along, &across);
            pass_on();
        }
    }

    std::string folder_;
};

}  // namespace

void set_rail_case(int ire, const FileCase& read, const std::string& folder) {
    RailSetting(ire, read, folder).set();
}

}  // namespace contactd::cntc

// An input file of the CONTACT program, set to the contact problems of a result element.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "interface/file_setting.hpp"

using namespace contactd::cntc;

namespace {

/// Values of the potential contact behind MX and MY, by IPOTCN.
const std::map<int, std::vector<const char*>> names_of_areas{
    {-6, {"AA", "BNEG", "BPOS", "SCALE"}}, {-5, {"AA", "BB", "SCALE"}},   {-4, {"A1", "BB", "SCALE"}},
    {-3, {"AA", "BB", "SCALE"}},           {-2, {"A1", "AOB", "SCALE"}},  {-1, {"A1", "B1", "SCALE"}},
    {1, {"XL", "YL", "DX", "DY"}},         {2, {"XL", "YL", "XH", "YH"}}, {3, {"XC1", "YC1", "DX", "DY"}},
    {4, {"XC1", "YC1", "XCM", "YCM"}}};

std::string text_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    std::string text;
    constexpr std::size_t piece = 1 << 16;
    while (file && text.size() <= contactd::most_contact_file_bytes) {  // the reader refuses what is longer
        const std::size_t size = text.size();
        text.resize(size + piece);
        file.read(text.data() + size, piece);
        text.resize(size + static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof() && text.size() <= contactd::most_contact_file_bytes)
        throw Refused(error_code::input, "The file \"" + name + "\" cannot be read.");
    return text;
}

void check(const FileCase& read, bool on_rails, const std::string& where) {
    if (!read.errors.empty()) throw Refused(error_code::input, where + read.errors.front() + ".");
    const int module = on_rails ? module_number::wheel_rail : module_number::basic_contact;
    if (read.module_number != module)
        throw Refused(error_code::input, where + "The case in line " + std::to_string(read.line) + " is of module " +
                                             std::to_string(read.module_number) +
                                             ", but the result element was initialized for module " +
                                             std::to_string(module) + ".");
}

/// The cases of a result element, or of files that name none: one for each of its problems, or for a wheel on a rail.
std::map<int, FileCase> cases_of(const std::string& name, int ire, bool on_rails) {
    const std::string text = text_of(name), where = "In the file \"" + name + "\": ";
    contactd::ContactFileReader reader(text, name);
    std::map<int, FileCase> cases;
    while (const auto read = reader.next()) {
        if (read->reid.value_or(ire) != ire) continue;
        check(*read, on_rails, where);
        if (!cases.emplace(on_rails ? 1 : read->cpid.value_or(1), *read).second)
            throw Refused(error_code::input,
                          where + "A second case begins in line " + std::to_string(read->line) +
                              "; a contact problem has one case at a time. Write each case into a separate file.");
    }
    if (!reader.errors().empty()) throw Refused(error_code::input, where + reader.errors().front() + ".");
    if (cases.empty())
        throw Refused(error_code::input, where + "There is no case of the result element " + std::to_string(ire) + ".");
    return cases;
}

/// Calls the functions of the interface with the values of a case of basic contact.
class BasicSetting : private FileSetting {
   public:
    using FileSetting::FileSetting;

    /// Throws Refused, in the words of the function that refused it.
    void set() {
        const UnitsOfFile units(ire_, icp_);
        flags({});
        solvers();
        material();
        heat();
        friction();
        area();
        motion();
        load();
        blocks();
    }

   private:
    void area() {
        int kind = integer("IPOTCN");
        const auto found = names_of_areas.find(kind);
        if (found == names_of_areas.end()) refuse("IPOTCN = " + std::to_string(kind) + " is not supported.");
        std::vector<double> values{double(integer("MX")), double(integer("MY"))};
        for (const char* name : found->second) values.push_back(real(name));
        int count = static_cast<int>(values.size());
        (kind < 0 ? cntc_sethertzcontact : cntc_setpotcontact)(&ire_, &icp_, &kind, &count, values.data());
        pass_on();
        if (kind > 0) distance();
    }

    void distance() {
        if (integer("IPLAN") != 1)
            refuse("A planform, IPLAN = " + std::to_string(integer("IPLAN")) + ", is not supported.");
        int base = integer("IBASE");
        std::vector<double> values;
        switch (base) {
            case 1:
                values = reals({"B1", "B2", "B3", "B4", "B5", "B6"});
                break;
            case 2:
                values = reals({"XM", "RM", "Y1", "DY1"});
                values.insert(values.begin(), static_cast<double>(list("HEIGHTS").size()));
                for (const double height : list("HEIGHTS")) values.push_back(height);
                break;
            case 3:
                values = reals({"B1", "B2", "B3", "B4", "B5", "B6", "B7", "B8"});
                break;
            default:
                values = list("GAP");
        }
        int count = static_cast<int>(values.size());
        cntc_setundeformeddistc(&ire_, &icp_, &base, &count, values.data());
        pass_on();
    }

    void motion() {
        if (digit("T") == 0) return;
        if (real("SPINXO") != 0 || real("SPINYO") != 0)
            refuse("A centre of spin, SPINXO and SPINYO, other than the origin is not supported.");
        const int force = digit("F");
        double x = force == 0 ? real("CKSI") : 0, y = force == 2 ? 0 : real("CETA"), phi = real("CPHI");
        cntc_setcreepages(&ire_, &icp_, &x, &y, &phi);
        pass_on();
        if (force > 0) {
            double fx = real("FX"), fy = force == 2 ? real("FY") : 0;
            cntc_settangentialforces(&ire_, &icp_, &fx, &fy);
            pass_on();
        }
        digit("T") == 1 ? shift() : roll();
        extra_slip();
    }

    void shift() {
        double step = 1;
        cntc_settimestep(&ire_, &icp_, &step);
        pass_on();
    }

    void roll() {
        const auto ahead = read_.values.find("FACPHI");
        if (ahead != read_.values.end() && std::abs(std::get<double>(ahead->second) - 1.0 / 6) > 1e-12)
            refuse("FACPHI is not supported; the spin is evaluated a sixth of a step ahead.");
        double chi = real("CHI"), dq = real("DQ"), velocity = real("VELOC");
        cntc_setrollingstepsize(&ire_, &icp_, &chi, &dq);
        pass_on();
        cntc_setreferencevelocity(&ire_, &icp_, &velocity);
        pass_on();
    }

    void extra_slip() {
        const int kind = integer("EXRHS");
        if (kind == 0) return;
        if (kind != 9) refuse("E = " + std::to_string(kind) + " is not supported; use 0 or 9.");
        auto x = list("SLIP_X"), y = list("SLIP_Y");
        int count = static_cast<int>(x.size());
        cntc_setextrarigidslip(&ire_, &icp_, &count, x.data(), y.data());
        pass_on();
    }

    void load() {
        double value = real(digit("N") == 0 ? "PEN" : "FN");
        (digit("N") == 0 ? cntc_setpenetration : cntc_setnormalforce)(&ire_, &icp_, &value);
        pass_on();
    }
};

}  // namespace

/// Every kind of file, `itype`, is read as an input file.
extern "C" void cntc_readinpfile(int* ire, int*, const char* name, int* len_name, int* ierror) {
    const int code = answer("cntc_readinpfile", [&] {
        require(ierror, "ierror");
        require(name, "name");
        const int length = integer(len_name, "len_name"), element = number_of(ire);
        if (length < 1) throw Refused(error_code::input, "The name of the file is empty.");
        const std::string file(name, static_cast<std::size_t>(length));
        const bool on_rails = of_rail(ire);
        for (const auto& [icp, read] : cases_of(file, element, on_rails)) {
            if (on_rails)
                set_rail_case(element, read, std::filesystem::path(file).parent_path().string());
            else
                BasicSetting(element, icp, read).set();
        }
    });
    if (ierror != nullptr) *ierror = code;
}
CONTACTD_FORTRAN_NAME(cntc_readinpfile)

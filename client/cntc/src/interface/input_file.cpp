// An input file of the CONTACT program, set to the contact problems of a result element.
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "contactd/read_contact_file.hpp"
#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

using FileCase = contactd::ContactCase;

constexpr int basic_contact = 3;

/// Values of the potential contact behind MX and MY, by IPOTCN.
const std::map<int, std::vector<const char*>> names_of_areas{
    {-5, {"AA", "BB", "SCALE"}},   {-4, {"A1", "BB", "SCALE"}},     {-3, {"AA", "BB", "SCALE"}},
    {-2, {"A1", "AOB", "SCALE"}},  {-1, {"A1", "B1", "SCALE"}},     {1, {"XL", "YL", "DX", "DY"}},
    {2, {"XL", "YL", "XH", "YH"}}, {3, {"XC1", "YC1", "DX", "DY"}}, {4, {"XC1", "YC1", "XCM", "YCM"}}};

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

void check(const FileCase& read, const std::string& where) {
    if (!read.errors.empty()) throw Refused(error_code::input, where + read.errors.front() + ".");
    if (read.module_number != basic_contact)
        throw Refused(error_code::other, where + "Wheel on rail (module 1), line " + std::to_string(read.line) +
                                             ", is not covered; contactd has basic contact here, module 3.");
}

/// The cases of a result element, or of files that name none: one for each of its problems.
std::map<int, FileCase> cases_of(const std::string& name, int ire) {
    const std::string text = text_of(name), where = "In the file \"" + name + "\": ";
    contactd::ContactFileReader reader(text, name);
    std::map<int, FileCase> cases;
    while (const auto read = reader.next()) {
        if (read->reid.value_or(ire) != ire) continue;
        check(*read, where);
        if (!cases.emplace(read->cpid.value_or(1), *read).second)
            throw Refused(error_code::input, where + "A second case begins in line " + std::to_string(read->line) +
                                                 "; a contact problem has one at a time. Give each a file of its own.");
    }
    if (!reader.errors().empty()) throw Refused(error_code::input, where + reader.errors().front() + ".");
    if (cases.empty())
        throw Refused(error_code::input, where + "There is no case of the result element " + std::to_string(ire) + ".");
    return cases;
}

/// Throws what the last call of a function of the interface refused.
void pass_on() {
    int code = 0;
    const std::string sentence = contactd_cntc_last_error(&code);
    if (code != 0) throw Refused(code, sentence);
}

/// Numbers are in units of the file, mm and N on body 1, while this lives.
class UnitsOfFile {
   public:
    UnitsOfFile(int ire, int icp) : ire_(ire), icp_(icp) {
        int none = flag::none;  // which makes the problem, where it is named for the first time
        cntc_setflags(&ire_, &icp_, &one_, &none, &none);
        pass_on();
        cntc_getflags(&ire_, &icp_, &one_, &flag_, &before_);
        set(units_mm_on_body_1.code);
    }
    ~UnitsOfFile() { set(before_); }
    UnitsOfFile(const UnitsOfFile&) = delete;
    UnitsOfFile& operator=(const UnitsOfFile&) = delete;

   private:
    void set(int code) { cntc_setflags(&ire_, &icp_, &one_, &flag_, &code); }

    int ire_, icp_, one_ = 1, flag_ = flag::units, before_ = units_mm_on_body_1.code;
};

/// Calls the functions of the interface with the values of a case.
class Setting {
   public:
    Setting(int ire, int icp, const FileCase& read) : ire_(ire), icp_(icp), read_(read) {}

    /// Throws Refused, in the words of the function that refused it.
    void set() {
        const UnitsOfFile units(ire_, icp_);
        flags();
        solvers();
        material();
        friction();
        area();
        motion();
        load();
        blocks();
    }

   private:
    double real(const char* name) const { return std::get<double>(read_.values.at(name)); }
    int integer(const char* name) const { return std::get<int>(read_.values.at(name)); }
    int digit(const char* name) const { return read_.digits.at(name); }
    std::vector<double> list(const char* name) const {
        return *std::get<contactd::ContactNumbers>(read_.values.at(name));
    }
    std::vector<double> reals(std::initializer_list<const char*> names) const {
        std::vector<double> values;
        for (const char* name : names) values.push_back(real(name));
        return values;
    }

    [[noreturn]] static void refuse(const std::string& sentence) { throw Refused(error_code::other, sentence); }

    void flags() {
        std::array codes{flag::previous,  flag::bound,    flag::tangential, flag::force,
                         flag::influence, flag::material, flag::heat,       flag::estimate};
        std::array values{digit("P"),        digit("B"), digit("T"), digit("F"),
                          integer("INFLCF"), digit("M"), digit("H"), digit("I")};
        int count = static_cast<int>(codes.size());
        cntc_setflags(&ire_, &icp_, &count, codes.data(), values.data());
        pass_on();
    }

    void solvers() {
        int method = 0, ints = 4, count = 1;
        std::array bounds{integer("MAXGS"), integer("MAXIN"), integer("MAXNR"), integer("MAXOUT")};
        double eps = real("EPS");
        cntc_setsolverflags(&ire_, &icp_, &method, &ints, bounds.data(), &count, &eps);
        pass_on();
    }

    void material() {
        auto values = reals({"POISS1", "POISS2", "GG1", "GG2"});
        int method = 0, count = 4;
        cntc_setmaterialparameters(&ire_, &icp_, &method, &count, values.data());
        pass_on();
    }

    void friction() {
        const int law = integer("FRCLAW");
        int method = 10 * integer("VARFRC") + law;
        const auto& set = read_.friction->front();
        std::vector<double> values;
        if (law == 0)
            values = {set.at("FSTAT"), set.at("FSTAT")};
        else if (law != 6)
            for (const char* name : {"FKIN", "F1", "SABSH1", "F2", "SABSH2"}) values.push_back(set.at(name));
        if (law != 0) values.insert(values.end(), {real("MEMDST"), real("MEM_S0")});
        int count = static_cast<int>(values.size());
        cntc_setfrictionmethod(&ire_, &icp_, &method, &count, values.data());
        pass_on();
    }

    void area() {
        int kind = integer("IPOTCN");
        const auto found = names_of_areas.find(kind);
        if (found == names_of_areas.end()) refuse("IPOTCN = " + std::to_string(kind) + " is not covered.");
        std::vector<double> values{double(integer("MX")), double(integer("MY"))};
        for (const char* name : found->second) values.push_back(real(name));
        int count = static_cast<int>(values.size());
        (kind < 0 ? cntc_sethertzcontact : cntc_setpotcontact)(&ire_, &icp_, &kind, &count, values.data());
        pass_on();
        if (kind > 0) distance();
    }

    void distance() {
        if (integer("IPLAN") != 1)
            refuse("A planform, IPLAN = " + std::to_string(integer("IPLAN")) + ", is not covered.");
        int base = integer("IBASE");
        std::vector<double> values;
        if (base == 1)
            values = reals({"B1", "B2", "B3", "B4", "B5", "B6"});
        else if (base == 9)
            values = list("GAP");
        else
            refuse("IBASE = " + std::to_string(base) + " is not covered; contactd has 1 and 9 here.");
        int count = static_cast<int>(values.size());
        cntc_setundeformeddistc(&ire_, &icp_, &base, &count, values.data());
        pass_on();
    }

    void motion() {
        if (digit("T") == 0) return;
        if (real("SPINXO") != 0 || real("SPINYO") != 0)
            refuse("A centre of spin, SPINXO and SPINYO, is not covered; it is the origin.");
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
            refuse("FACPHI is not covered; spin is taken a sixth of a step ahead.");
        double chi = real("CHI"), dq = real("DQ"), velocity = real("VELOC");
        cntc_setrollingstepsize(&ire_, &icp_, &chi, &dq);
        pass_on();
        cntc_setreferencevelocity(&ire_, &icp_, &velocity);
        pass_on();
    }

    void extra_slip() {
        const int kind = integer("EXRHS");
        if (kind == 0) return;
        if (kind != 9) refuse("E = " + std::to_string(kind) + " is not covered; contactd has 0 and 9.");
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

    void blocks() {
        if (digit("S") == 0 || !read_.subsurface) return;
        int number = 0;
        for (const auto& block : *read_.subsurface) {
            ++number;
            const auto axis = [&](const char* name) {
                const auto found = block.find(name);
                return found == block.end() ? std::vector<double>(1)
                                            : *std::get<contactd::ContactNumbers>(found->second);
            };
            const bool has_elements = block.contains("IX"), has_places = block.contains("X");
            auto x = axis(has_elements ? "IX" : "X"), y = axis(has_elements ? "IY" : "Y"), z = axis("Z");
            int kind = has_places ? 9 : has_elements ? 7 : 5;
            int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size()), nz = static_cast<int>(z.size());
            subs_addblock(&ire_, &icp_, &number, &kind, &nx, &ny, &nz, x.data(), y.data(), z.data());
            pass_on();
        }
    }

    int ire_, icp_;
    const FileCase& read_;
};

}  // namespace

/// Every kind of file, `itype`, is read as an input file.
extern "C" void cntc_readinpfile(int* ire, int*, const char* name, int* len_name, int* ierror) {
    const int code = answer("cntc_readinpfile", [&] {
        require(ierror, "ierror");
        require(name, "name");
        const int length = integer(len_name, "len_name"), element = number_of(ire);
        if (length < 1) throw Refused(error_code::input, "The name of the file is empty.");
        for (const auto& [icp, read] : cases_of({name, static_cast<std::size_t>(length)}, element))
            Setting(element, icp, read).set();
    });
    if (ierror != nullptr) *ierror = code;
}
CONTACTD_FORTRAN_NAME(cntc_readinpfile)

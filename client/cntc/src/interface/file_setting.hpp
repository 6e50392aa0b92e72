// The common part of cases of input files of both modules: values, which functions of the interface set.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "contactd/read_contact_file.hpp"
#include "interface/entry.hpp"

namespace contactd::cntc {

using FileCase = contactd::ContactCase;

/// Throws what the last call of a function of the interface refused.
void pass_on();

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

/// Calls the functions of the interface with the values of a case, as far as those of both modules are the same.
class FileSetting {
   public:
    FileSetting(int ire, int icp, const FileCase& read) : ire_(ire), icp_(icp), read_(read) {}

   protected:
    double real(const char* name) const { return std::get<double>(read_.values.at(name)); }
    /// Zero where the file never had it.
    double real_or_none(const char* name) const { return read_.values.contains(name) ? real(name) : 0; }
    int integer(const char* name) const { return std::get<int>(read_.values.at(name)); }
    int digit(const char* name) const { return read_.digits.at(name); }
    std::vector<double> list(const char* name) const {
        return *std::get<contactd::ContactNumbers>(read_.values.at(name));
    }
    std::vector<double> reals(std::initializer_list<const char*> names) const;
    [[noreturn]] static void refuse(const std::string& sentence) { throw Refused(error_code::other, sentence); }

    /// Sets those of both modules, and codes with values that one of them has.
    void flags(std::vector<std::array<int, 2>> own);
    void solvers();
    void material();
    void damping();
    void heat();
    void friction();
    void blocks();

    int ire_, icp_;
    const FileCase& read_;
};

/// Sets a wheel on a rail; profiles are named relative to the folder. Throws Refused, in the words of the function that
/// refused it.
void set_rail_case(int ire, const FileCase& read, const std::string& folder);

}  // namespace contactd::cntc

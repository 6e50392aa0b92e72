// The functions of the library, called with values, and problems to call them with.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contactd_cntc.h"

namespace contactd::cntc::test {

using Values = std::vector<double>;

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// What the last call of this thread left behind.
inline int last_code() {
    int code = 0;
    contactd_cntc_last_error(&code);
    return code;
}
inline std::string last_sentence() {
    return contactd_cntc_last_error(nullptr);
}

struct ContactForces {
    double fn = no_number, fx = no_number, fy = no_number, mz = no_number;

    bool operator==(const ContactForces&) const = default;
};
struct PatchAreas {
    double contact = no_number, adhesion = no_number, slip = no_number;
};
struct Creepages {
    double vx = no_number, vy = no_number, phi = no_number;
};
struct Tractions {
    Values pn, px, py;
};

/// A contact problem by its numbers. Each test has result elements of its own; what it leaves, finalize removes.
class Case {
   public:
    explicit Case(int ire, int icp = 1, bool fresh = true) : ire_(ire), icp_(icp) {
        if (!fresh) return;
        int module = 3, version = 0, error = 0, length = 0;
        cntc_initialize(&ire_, &module, &version, &error, "", &length);
    }
    int* ire() { return &ire_; }
    int* icp() { return &icp_; }

    void flag(int code, int value) {
        int count = 1;
        cntc_setflags(&ire_, &icp_, &count, &code, &value);
    }
    int get_flag(int code) {
        int count = 1, value = 0;
        cntc_getflags(&ire_, &icp_, &count, &code, &value);
        return value;
    }
    void material(double nu1, double nu2, double G1, double G2) {
        int method = 0, count = 4;
        std::array values{nu1, nu2, G1, G2};
        cntc_setmaterialparameters(&ire_, &icp_, &method, &count, values.data());
    }
    void friction(int method, Values values) {
        int count = static_cast<int>(values.size());
        cntc_setfrictionmethod(&ire_, &icp_, &method, &count, values.data());
    }
    void coulomb(double mu) { friction(0, {mu, mu}); }
    void hertz(int option, Values values) {
        int count = static_cast<int>(values.size());
        cntc_sethertzcontact(&ire_, &icp_, &option, &count, values.data());
    }
    void potential(int option, Values values) {
        int count = static_cast<int>(values.size());
        cntc_setpotcontact(&ire_, &icp_, &option, &count, values.data());
    }
    void distance(int base, Values values) {
        int count = static_cast<int>(values.size());
        cntc_setundeformeddistc(&ire_, &icp_, &base, &count, values.data());
    }
    void normal_force(double fn) { cntc_setnormalforce(&ire_, &icp_, &fn); }
    void penetration(double pen) { cntc_setpenetration(&ire_, &icp_, &pen); }
    void creepages(double vx, double vy, double phi) { cntc_setcreepages(&ire_, &icp_, &vx, &vy, &phi); }
    void tangential_forces(double fx, double fy) { cntc_settangentialforces(&ire_, &icp_, &fx, &fy); }
    void rolling_step(double chi, double dq) { cntc_setrollingstepsize(&ire_, &icp_, &chi, &dq); }
    void velocity(double v) { cntc_setreferencevelocity(&ire_, &icp_, &v); }
    void time_step(double dt) { cntc_settimestep(&ire_, &icp_, &dt); }
    void extra_slip(Values wx, Values wy) {
        int count = static_cast<int>(wx.size());
        cntc_setextrarigidslip(&ire_, &icp_, &count, wx.data(), wy.data());
    }
    void tolerance(double eps) {
        int method = 0, ints = 4, reals = 1;
        std::array bounds{999, 30, 30, 1};
        cntc_setsolverflags(&ire_, &icp_, &method, &ints, bounds.data(), &reals, &eps);
    }

    int calculate() {
        int error = -1000;
        cntc_calculate(&ire_, &icp_, &error);
        return error;
    }
    ContactForces forces() {
        ContactForces f;
        cntc_getcontactforces(&ire_, &icp_, &f.fn, &f.fx, &f.fy, &f.mz);
        return f;
    }
    PatchAreas areas() {
        PatchAreas a;
        cntc_getcontactpatchareas(&ire_, &icp_, &a.contact, &a.adhesion, &a.slip);
        return a;
    }
    Creepages found_creepages() {
        Creepages c;
        cntc_getcreepages(&ire_, &icp_, &c.vx, &c.vy, &c.phi);
        return c;
    }
    double found_penetration() {
        double pen = 0;
        cntc_getpenetration(&ire_, &icp_, &pen);
        return pen;
    }
    double max_pressure() {
        double p = 0;
        cntc_getmaximumpressure(&ire_, &icp_, &p);
        return p;
    }
    double max_traction() {
        double p = 0;
        cntc_getmaximumtraction(&ire_, &icp_, &p);
        return p;
    }
    int elements() {
        int mx = 0, my = 0;
        cntc_getnumelements(&ire_, &icp_, &mx, &my);
        return mx * my;
    }
    std::array<double, 2> element_size() {
        std::array<double, 2> size{};
        cntc_getgriddiscretization(&ire_, &icp_, &size[0], &size[1]);
        return size;
    }
    Values hertz_back(int length = 10) {
        Values values(static_cast<std::size_t>(length));
        cntc_gethertzcontact(&ire_, &icp_, &length, values.data());
        return values;
    }
    Values potential_back() {
        int length = 6;
        Values values(6);
        cntc_getpotcontact(&ire_, &icp_, &length, values.data());
        return values;
    }
    std::vector<int> division() {
        int length = elements();
        std::vector<int> values(static_cast<std::size_t>(length));
        cntc_getelementdivision(&ire_, &icp_, &length, values.data());
        return values;
    }
    Tractions tractions() {
        int length = elements();
        const Values empty(static_cast<std::size_t>(length));
        Tractions t{empty, empty, empty};
        cntc_gettractions(&ire_, &icp_, &length, t.pn.data(), t.px.data(), t.py.data());
        return t;
    }
    Values field(int code) {
        int length = elements();
        Values values(static_cast<std::size_t>(length));
        cntc_getfielddata(&ire_, &icp_, &code, &length, values.data());
        return values;
    }
    /// [out + 4 in]
    Values sensitivities(int lenout = 4, int lenin = 4) {
        Values values(static_cast<std::size_t>(lenout) * static_cast<std::size_t>(lenin));
        cntc_getsensitivities(&ire_, &icp_, &lenout, &lenin, values.data());
        return values;
    }

   private:
    int ire_, icp_;
};

/// Steel, semi-axes 6 x 4 mm under 50 kN, mu = 0.3, 25 x 25 elements of 1.1 times the ellipse's box, some creepage.
inline Case wheel(int ire, int icp = 1, bool fresh = true) {
    Case wheel(ire, icp, fresh);
    wheel.material(0.28, 0.28, 82000, 82000);
    wheel.coulomb(0.3);
    wheel.hertz(-3, {25, 25, 6, 4, 1.1});
    wheel.normal_force(50000);
    wheel.creepages(0.002, 0.001, 1e-4);
    return wheel;
}

}  // namespace contactd::cntc::test

// A wheel on a rail by the functions of the library, called with values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cntc/calls.hpp"
#include "contactd/make_profile.hpp"
#include "core/wheel_rail/manchester.hpp"
#include "types/number_text.hpp"

namespace contactd::cntc::test {

class RailCase {
   public:
    explicit RailCase(int ire, int module = 1) : ire_(ire), whole(ire, -1, false) {
        int version = 0, error = 0, length = 0;
        cntc_initialize(&ire_, &module, &version, &error, "", &length);
    }
    int* ire() { return &ire_; }
    /// Its patches, from 1 on.
    Case patch(int icp) { return Case(ire_, icp, false); }

    void profile(bool wheel, Values values, std::vector<int> ints = {}, Values reals = {1}) {
        int points = static_cast<int>(values.size() / 2);
        ints.insert(ints.begin(), wheel ? 1 : 0);
        int nints = static_cast<int>(ints.size()), nreals = static_cast<int>(reals.size());
        cntc_setprofileinputvalues(&ire_, &points, values.data(), &nints, ints.data(), &nreals, reals.data());
    }
    void profile_file(const std::string& name, std::vector<int> ints = {-1}, Values reals = {1}) {
        int length = static_cast<int>(name.size());
        int nints = static_cast<int>(ints.size()), nreals = static_cast<int>(reals.size());
        cntc_setprofileinputfname(&ire_, name.c_str(), &length, &nints, ints.data(), &nreals, reals.data());
    }
    void track(int digit, Values values) { pass(cntc_settrackdimensions, digit, values); }
    void wheelset(int digit, Values values) { pass(cntc_setwheelsetdimensions, digit, values); }
    void position(int digit, Values values) { pass(cntc_setwheelsetposition, digit, values); }
    void velocity(int digit, Values values) { pass(cntc_setwheelsetvelocity, digit, values); }
    void flexibility(int digit, Values values) { pass(cntc_setwheelsetflexibility, digit, values); }
    void vertical_force(double fz) { cntc_setverticalforce(&ire_, &fz); }

    int patches() {
        int count = -1;
        cntc_getnumcontactpatches(&ire_, &count);
        return count;
    }
    Values location(int icp, int length = 38) {
        Values values(static_cast<std::size_t>(length), no_number);
        cntc_getcontactlocation(&ire_, &icp, &length, values.data());
        return values;
    }
    Values global_forces(int icp = -1, int length = 24) {
        Values values(static_cast<std::size_t>(length), no_number);
        cntc_getglobalforces(&ire_, &icp, &length, values.data());
        return values;
    }
    Values wheelset_position() { return six(cntc_getwheelsetposition); }
    Values wheelset_velocity() { return six(cntc_getwheelsetvelocity); }
    Values profile_values(int task, bool wheel, int length, int sampling = 0, double step = 1) {
        std::array ints{wheel ? 1 : 0, sampling};
        int nints = 2, nreals = 1;
        Values values(static_cast<std::size_t>(length), no_number);
        cntc_getprofilevalues_new(&ire_, &task, &nints, ints.data(), &nreals, &step, &length, values.data());
        return values;
    }

   private:
    void pass(void (*function)(int*, int*, int*, double*), int digit, Values& values) {
        int count = static_cast<int>(values.size());
        function(&ire_, &digit, &count, values.data());
    }
    Values six(void (*function)(int*, int*, double*)) {
        int length = 6;
        Values values(6, no_number);
        function(&ire_, &length, values.data());
        return values;
    }

    int ire_;

   public:
    Case whole;  ///< what it has in common with basic contact
};

inline Values values_of(const ProfileSpec& spec) {
    Values values;
    const Profile profile = make_profile(spec);
    for (const auto& [y, z] : profile.curve.points()) values.insert(values.end(), {y, z});
    return values;
}

inline const Values& s1002() {
    static const Values values = values_of({ProfileKind::wheel, S1002{}});
    return values;
}
inline const Values& rail_60e1() {
    static const Values values = values_of({ProfileKind::rail, Rail60E1{1.0 / 40}});
    return values;
}

/// Returns what core is told of such a table.
inline ProfileSpec spec_of(ProfileKind kind, const Values& values) {
    ProfileFile file;
    file.name = "values";
    file.unit = 1;
    for (std::size_t i = 0; i < values.size(); i += 2)
        file.text += number_text(values[i]) + " " + number_text(values[i + 1]) + "\n";
    file.kinks.rest = file.kinks.angle / 5;
    return {kind, file};
}

/// In units of `length` mm.
inline RailCase manchester_wheel(int ire, Side side, double length = 1) {
    RailCase rail(ire);
    rail.whole.flag(1967, side == Side::left ? 0 : 1);
    rail.whole.material(0.28, 0.28, 82000 * length * length, 82000 * length * length);
    rail.whole.coulomb(0.3);
    rail.whole.potential(-1, {0.2 / length, 0.2 / length, 1.5707963267948966, 8 / length, 4 / length, 12 / length});
    rail.profile(false, rail_60e1());
    rail.profile(true, s1002());
    const double y = side == Side::left ? -760.532353 : 760.532353;
    rail.track(3, {0, y / length, -0.000023 / length, 0, 0, 0, 0, 0, 0, 0, 0});
    rail.wheelset(3, {1360 / length, -70 / length, 460 / length});
    return rail;
}

inline void place(RailCase& rail, const contactd::test::ManchesterCase& known, double length = 1) {
    rail.position(2, {0, known.y / length, 0, known.roll, known.yaw, 0});
    rail.velocity(2, {2000 / length, 0, 0, 0, 0, known.pitch_rate});
    rail.vertical_force(10000);
}

}  // namespace contactd::cntc::test

#include "contactd/read_contact_slices.hpp"

#include <cmath>
#include <optional>

#include "contactd/error.hpp"
#include "groups.hpp"

namespace contactd {
namespace {

using namespace contact_files;

constexpr double least_step = 1e-3;  // smallest distance of slices
constexpr int most_features = 49;    // number of words of a line without the position
constexpr double same_place = 1e-6;  // relative tolerance of the position in a line of features

class SlicesReader {
   public:
    explicit SlicesReader(Reading& reading) : reading_(reading) {}

    ContactSlices read() {
        const auto scale = read_values(reading_, "U_OFFSET U_SCALE");
        made_.u_offset = std::get<double>(scale.at("U_OFFSET"));
        made_.u_scale = std::get<double>(scale.at("U_SCALE"));
        if (!(made_.u_scale > 0)) fail("has U_SCALE = " + std::to_string(made_.u_scale) + "; it must be positive");
        const int slices = counted("NSLC", 1, most_contact_slices);
        const auto counts = read_values(reading_, "NFEAT# NKINK# NACCEL#");
        features_ = bounded(counts, "NFEAT", 0, most_features);
        const int parts = std::max(0, features_ - 1);
        const int kinks = bounded(counts, "NKINK", 0, parts), accelerations = bounded(counts, "NACCEL", 0, parts);
        made_.is_approximated = counted("U_INTPOL", 1, 2) == 2;
        for (int i = 0; i < slices; ++i) add_slice();
        made_.kinks = parts_of("P_KINK", kinks);
        made_.accelerations = parts_of("P_ACCEL", accelerations);
        if (features_ >= 2)
            for (std::size_t i = 0; i < made_.slices.size(); ++i) read_features(i);
        return std::move(made_);
    }

   private:
    [[noreturn]] void fail(const std::string& problem) const {
        reading_.lines.fail(reading_.lines.words().front(), problem);
    }

    int bounded(const ByName<ContactValue>& group, const char* name, int least, int most) const {
        const int value = std::get<int>(group.at(name));
        if (value < least || value > most)
            fail("has " + std::string(name) + " = " + std::to_string(value) + "; here it must be " +
                 std::to_string(least) + " to " + std::to_string(most));
        return value;
    }

    int counted(const char* name, int least, int most) {
        return bounded(read_values(reading_, std::string(name) + "#"), name, least, most);
    }

    void add_slice() {
        const auto slice = read_values(reading_, "U_SLC FNAME'");
        const double place = std::get<double>(slice.at("U_SLC")), u = made_.u_scale * (made_.u_offset + place);
        if (!made_.slices.empty() && !(u - made_.slices.back().u > least_step))
            fail("has the slice at " + std::to_string(u) + " after that at " + std::to_string(made_.slices.back().u) +
                 "; slices must increase by more than 0.001");
        made_.slices.push_back({u, std::get<std::string>(slice.at("FNAME")), {}});
        places_.push_back(place);
    }

    std::vector<int> parts_of(const char* name, int count) {
        std::vector<int> parts;
        if (count == 0) return parts;
        for (const double number : read_array(reading_, name, static_cast<std::size_t>(count), "#")) {
            if (number < 1 || number > features_ - 2)
                fail("has " + std::string(name) + " = " + std::to_string(static_cast<int>(number)) +
                     "; parts have the numbers 1 to NFEAT - 2, which is " + std::to_string(features_ - 2));
            parts.push_back(static_cast<int>(number));
        }
        return parts;
    }

    /// Reads a line of features: the position of a slice, which is repeated, and the positions of its features.
    void read_features(std::size_t at) {
        std::vector<double> row =
            read_array(reading_, "U_SLC and the features", static_cast<std::size_t>(features_) + 1);
        if (std::abs(row[0] - places_[at]) > same_place * (1 + std::abs(places_[at])))
            fail("has the features at " + std::to_string(row[0]) + " where those of the slice at " +
                 std::to_string(places_[at]) + " are expected");
        row.erase(row.begin());
        check_order(row);
        made_.slices[at].features = std::move(row);
    }

    /// Requires missing features to be at the ends of the list, and the others to increase.
    void check_order(const std::vector<double>& row) const {
        double last = -1;
        bool has_ended = false;
        for (const double feature : row) {
            if (feature < 0) {
                has_ended = has_ended || last >= 0;
                continue;
            }
            if (has_ended) fail("has a feature after a missing one; missing features must be at the ends of the list");
            if (feature < last)
                fail("has the feature at " + std::to_string(feature) + " after that at " + std::to_string(last) +
                     "; features must ascend");
            last = feature;
        }
    }

    Reading& reading_;
    ContactSlices made_;
    std::vector<double> places_;  ///< U_SLC
    int features_ = 0;
};

}  // namespace

ContactSlices read_contact_slices(std::string_view text, const std::string& name) {
    InputLines lines(text, name);
    ContactCase unused;
    Reading reading{lines, unused};
    try {
        return SlicesReader(reading).read();
    } catch (const InvalidArgument& refusal) {
        throw InvalidArgument(name + ", " + refusal.field(), refusal.problem());
    }
}

}  // namespace contactd

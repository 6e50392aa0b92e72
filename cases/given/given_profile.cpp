#include "given_profile.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "contactd/make_profile.hpp"
#include "contactd/read_contact_slices.hpp"
#include "contactd/read_profile.hpp"
#include "given/not_covered.hpp"
#include "types/number_text.hpp"

namespace contactd::cases {
namespace {

/// The features of lists without any: the ends of the profile, so that it has one part.
const std::vector<double> whole_profile{0, 1e5};

std::string ending_of(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    std::string ending = dot == std::string::npos ? "" : name.substr(dot);
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

bool is_one_of(const std::string& ending, std::initializer_list<const char*> endings) {
    return std::ranges::find(endings, ending) != endings.end();
}

bool is_wheel(const std::string& name, const ProfileOptions& options) {
    if (options.wheel) return *options.wheel;
    const std::string ending = ending_of(name);
    if (is_one_of(ending, {".prw", ".whl", ".slcw"})) return true;
    if (is_one_of(ending, {".prr", ".ban", ".slcs"})) return false;
    throw NotCovered(Subject::profile, "The ending of the file \"" + name +
                                           "\" does not identify a rail or a wheel. Set iparam(1) to 0 for a rail, or "
                                           "to 1 for a wheel (cntc_setprofileinputfname).");
}

ProfileKind kind_of(bool wheel) {
    return wheel ? ProfileKind::wheel : ProfileKind::rail;
}

/// Returns the points. Throws InvalidArgument if the profile cannot be used.
std::vector<ProfilePoint> points_of(const ProfileSpec& spec) {
    return make_profile(spec).curve.points();
}

/// Returns whether z points upwards if the shape does not show it, by the position of the least z.
bool runs_upwards(const std::vector<ProfilePoint>& points, bool wheel) {
    const auto by_z = [](const ProfilePoint& a, const ProfilePoint& b) { return a.z < b.z; };
    const auto least = std::ranges::min_element(points, by_z);
    const auto index = least - points.begin(), count = static_cast<std::ptrdiff_t>(points.size());
    if (!wheel) {
        const auto outer = count / 10;
        return !(outer <= index && index < count - outer);
    }
    const auto largest = std::ranges::max_element(points, by_z);
    const auto [left, right] = std::ranges::minmax(points, {}, &ProfilePoint::y);
    constexpr double face = 0.05;  // part of a wheel's width that belongs to an end
    const double edge = face * (right.y - left.y);
    const auto at_an_end = [&](const ProfilePoint& point) {
        return std::min(point.y - left.y, right.y - point.y) <= edge;
    };
    if (at_an_end(*least) || at_an_end(*largest)) return !at_an_end(*least);
    const ProfilePoint& middle = points[static_cast<std::size_t>((index + (largest - points.begin())) / 2)];
    const double share = (middle.y - least->y) / (largest->y - least->y);
    return middle.z < least->z + share * (largest->z - least->z);
}

/// Sets mirror_z for points whose shape does not show the direction of z.
ProfileSpec with_mirror_z(ProfileSpec spec, bool wheel) {
    ProfileFile& file = std::get<ProfileFile>(spec.shape);
    if (file.mirror_z) return spec;
    try {
        points_of(spec);
        return spec;
    } catch (const InvalidArgument&) {
        file.mirror_z = false;
        std::vector<ProfilePoint> points;
        try {
            points = points_of(spec);
        } catch (const InvalidArgument&) {
            file.mirror_z.reset();
            throw;
        }
        file.mirror_z = runs_upwards(points, wheel);
        return spec;
    }
}

ProfileSpec spec_of(std::string name, std::string text, bool wheel, const ProfileOptions& options) {
    const bool is_simpack = is_one_of(ending_of(name), {".prr", ".prw"});
    ProfileFile file;
    file.mirror_y = options.mirror_y == 1;
    if (is_simpack) {
        const ProfileSpec read = read_profile(text, name, kind_of(wheel));
        const auto& points = std::get<ProfilePoints>(read.shape);
        if (options.scale != 1) file.unit = points.unit * options.scale;
        if (options.mirror_y == -1 && points.mirror_y) file.mirror_y = true;
    } else {
        file.unit = options.scale;
    }
    file.name = std::move(name);
    file.text = std::move(text);
    if (options.mirror_z != 0) file.mirror_z = options.mirror_z == 1;
    if (options.smoothing > 0) {
        (options.smoother == 0 ? file.smoothing_lambda : file.smoothing_length) = options.smoothing;
        if (options.smoother == 2) file.smoothing_order = 3;
    }
    file.kinks = options.kinks;
    ProfileSpec spec{kind_of(wheel), std::move(file)};
    validate(spec);
    return with_mirror_z(std::move(spec), wheel);
}

std::string last_part(const std::string& name) {
    return std::filesystem::path(name).filename().string();
}

ProfileSpec spec_of_file(const std::string& name, bool wheel, const ProfileOptions& options, const NamedFiles& files) {
    return spec_of(last_part(name), files.text(name, most_profile_bytes), wheel, options);
}

GivenSurface slices_of(const std::string& name, bool wheel, const ProfileOptions& options, const NamedFiles& files) {
    const ContactSlices list = read_contact_slices(files.text(name, most_profile_bytes), last_part(name));
    GivenSurface surface;
    surface.spline = list.is_approximated ? SliceSpline::approximating : SliceSpline::cubic;
    for (const ContactSlice& slice : list.slices) {
        ProfileSpec spec = spec_of_file(beside(name, slice.file), wheel, options, files);
        if (wheel)
            surface.wheel_slices.push_back({slice.u, std::move(spec)});
        else
            surface.rail_slices.push_back(
                {slice.u, std::move(spec), slice.features.empty() ? whole_profile : slice.features});
    }
    return surface;
}

/// Replaces a number that is not positive by CONTACT's default.
double positive_or(double value, double otherwise) {
    return value > 0 ? value : otherwise;
}

/// Runs `read`. Its InvalidArgument becomes a NotCovered with the subject `profile`.
template <class Read>
ReadProfile reading(const Read& read) {
    try {
        return read();
    } catch (const InvalidArgument& error) {
        throw NotCovered(Subject::profile, error.what());
    }
}

}  // namespace

ProfileOptions profile_options(const ProfileNumbers& numbers, const Units& units) {
    if (numbers.smoother < 0 || numbers.smoother > 2)
        throw NotCovered(Subject::profile,
                         "ISMOOTH = " + std::to_string(numbers.smoother) +
                             " is not supported. Use 0, 1 or 2 (iparam(6) of cntc_setprofileinputfname).");
    ProfileOptions options;
    options.mirror_y = numbers.mirror_y;
    options.mirror_z = numbers.mirror_z;
    options.smoother = numbers.smoother;
    options.scale = positive_or(numbers.scale, units.length);
    options.smoothing = numbers.smoothing;
    const KinkRule usual;
    options.kinks.angle = positive_or(numbers.kink_high, usual.angle);
    options.kinks.rest = positive_or(numbers.kink_low, options.kinks.angle / 5);
    const double width = numbers.kink_width;
    // A width of 0 selects the default unless an angle is given.
    const bool is_given = width > 0 || (width == 0 && numbers.kink_high > 0);
    options.kinks.width = is_given ? width * units.length : usual.width;
    return options;
}

ReadProfile profile_from_file(const std::string& given_name, const ProfileOptions& options, const NamedFiles& files) {
    return reading([&] {
        const std::string name = with_slashes(given_name);
        const bool wheel = is_wheel(name, options);
        ReadProfile read{wheel, {}};
        if (is_one_of(ending_of(name), {".slcs", ".slcw"}))
            read.surface = slices_of(name, wheel, options, files);
        else
            read.surface.profile = spec_of_file(name, wheel, options, files);
        return read;
    });
}

ReadProfile profile_from_values(std::span<const double> values, const ProfileOptions& options) {
    return reading([&] {
        // The values become the text of a file, so that all options of files apply.
        std::string text;
        for (std::size_t i = 0; i + 1 < values.size(); i += 2)
            text += number_text(values[i]) + " " + number_text(values[i + 1]) + "\n";
        const bool wheel = options.wheel.value_or(true);
        ReadProfile read{wheel, {}};
        read.surface.profile = spec_of("values", std::move(text), wheel, options);
        return read;
    });
}

}  // namespace contactd::cases

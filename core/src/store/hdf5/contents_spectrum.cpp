// Reads and writes datasets of a longitudinally uniform body: the transform of its coefficients.
#include <algorithm>
#include <cmath>
#include <functional>

#include "contents_parts.hpp"

namespace contactd {
namespace {

constexpr const char* transform_name = "transform";
constexpr const char* frames_name = "frames";
constexpr std::size_t fewest_nodes = 5, most_nodes = 1000;

UnsetArray unset(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

}  // namespace

void write_spectrum(const WritableGroup& at, const StripSpectrum& spectrum) {
    at.contents.datasets[at.prefix + transform_name] = {{spectrum.nodes.size(), spectrum.component_size()},
                                                        unset(spectrum.values)};
    const WritableGroup transform = at.below(transform_name);
    put(transform, "axes",
        "wavenumber; pairs a >= b at a (a + 1)/2 + b of a = 3 I + i, b = 3 J + j: displacement i (x, s, n) of column "
        "I, "
        "load j of column J");
    put(transform, "units", "ds/G: ds is the width of a column; for cos(xi x), of x for sin(xi x)");
    put(transform, "wavenumbers", spectrum.nodes);
    put(transform, "xi0", spectrum.xi0);
    std::vector<double> frames;
    for (const StripFrame& frame : spectrum.frames) frames.insert(frames.end(), {frame.y, frame.z, frame.angle});
    at.contents.datasets[at.prefix + frames_name] = {{spectrum.frames.size(), 3}, unset(frames)};
    const WritableGroup places = at.below(frames_name);
    put(places, "axes", "column; y and z of its middle, angle of its normal from +z towards +y");
    put(places, "units", "y and z over ds, the width of a column; angle in rad");
}

StripSpectrum read_spectrum(const Group& at, double nu) {
    const FileContents::Array& transform = array(at, transform_name, 2);
    const FileContents::Array& frames = array(at, frames_name, 2);
    const std::size_t strips = frames.shape[0];
    if (strips < 1 || strips > most_strips || frames.shape[1] != 3)
        throw DamagedTable("The shape of frames in the file does not match its section.");
    const Group of_transform = at.below(transform_name);
    StripSpectrum spectrum;
    spectrum.strips = static_cast<int>(strips);
    spectrum.nu = nu;
    spectrum.xi0 = number(of_transform, "xi0");
    spectrum.nodes = numbers(of_transform, "wavenumbers");
    const std::size_t nodes = spectrum.nodes.size();
    const bool fits = nodes >= fewest_nodes && nodes <= most_nodes && transform.shape[0] == nodes &&
                      transform.shape[1] == spectrum.component_size() && spectrum.nodes.front() == 0 &&
                      spectrum.xi0 > 0 &&
                      std::ranges::adjacent_find(spectrum.nodes, std::greater_equal()) == spectrum.nodes.end() &&
                      std::ranges::all_of(transform.values, [](double value) { return std::isfinite(value); });
    if (!fits) throw DamagedTable("The shape of the transform in the file does not match its section.");
    spectrum.values.assign(transform.values.begin(), transform.values.end());
    for (std::size_t strip = 0; strip < strips; ++strip)
        spectrum.frames.push_back(
            {frames.values[3 * strip], frames.values[3 * strip + 1], frames.values[3 * strip + 2]});
    return spectrum;
}

}  // namespace contactd

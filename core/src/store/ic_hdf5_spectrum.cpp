// Datasets of a prism: the transform of its coefficients.
#include <algorithm>
#include <array>
#include <cmath>

#include "hdf5_attributes.hpp"
#include "ic_hdf5_parts.hpp"

namespace contactd {
namespace {

constexpr const char* transform_name = "transform";
constexpr const char* frames_name = "frames";
constexpr std::size_t most_nodes = 1000;

template <std::size_t axes>
void write(const H5::H5File& file, const char* name, const std::array<hsize_t, axes>& shape, const double* values) {
    file.createDataSet(name, H5::PredType::IEEE_F64LE, H5::DataSpace(axes, shape.data()))
        .write(values, H5::PredType::NATIVE_DOUBLE);
}

/// Its shape, of two axes.
std::array<hsize_t, 2> read(const H5::H5File& file, const char* name, hsize_t most, std::vector<double>& values) {
    const H5::DataSet dataset = file.openDataSet(name);
    const H5::DataSpace space = dataset.getSpace();
    std::array<hsize_t, 2> shape{};
    if (space.getSimpleExtentNdims() != 2)
        throw DamagedTable(std::string(name) + " of the file does not have two axes.");
    space.getSimpleExtentDims(shape.data());
    if (shape[0] < 1 || shape[1] < 1 || shape[0] > most || shape[1] > most)
        throw DamagedTable(std::string(name) + " of the file has a shape that no section has.");
    values.resize(shape[0] * shape[1]);
    dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
    return shape;
}

}  // namespace

void write_spectrum(H5::H5File& file, const ColumnSpectrum& spectrum) {
    write(file, transform_name, std::array<hsize_t, 2>{spectrum.nodes.size(), spectrum.component_size()},
          spectrum.values.data());
    H5::DataSet dataset = file.openDataSet(transform_name);
    put(dataset, "axes",
        "wavenumber; pairs a >= b at a (a + 1)/2 + b of a = 3 I + i, b = 3 J + j: displacement i (x, s, n) of column "
        "I, "
        "load j of column J");
    put(dataset, "units", "ds/G: ds is the width of a column; for cos(xi x), of x for sin(xi x)");
    put(dataset, "wavenumbers", spectrum.nodes);
    put(dataset, "xi0", spectrum.xi0);
    std::vector<double> frames;
    for (const ColumnFrame& frame : spectrum.frames) frames.insert(frames.end(), {frame.y, frame.z, frame.angle});
    write(file, frames_name, std::array<hsize_t, 2>{spectrum.frames.size(), 3}, frames.data());
    H5::DataSet places = file.openDataSet(frames_name);
    put(places, "axes", "column; y and z of its middle, angle of its normal from +z towards +y");
    put(places, "units", "y and z over ds, the width of a column; angle in rad");
}

ColumnSpectrum read_spectrum(const H5::H5File& file, double nu) {
    ColumnSpectrum spectrum;
    constexpr hsize_t most_pairs = hsize_t{3} * most_columns * (3 * most_columns + 1) / 2;
    const auto [nodes, pairs] = read(file, transform_name, most_pairs, spectrum.values);
    std::vector<double> frames;
    const auto [columns, three] = read(file, frames_name, most_columns, frames);
    const H5::DataSet dataset = file.openDataSet(transform_name);
    spectrum.columns = static_cast<int>(columns);
    spectrum.nu = nu;
    spectrum.xi0 = number(dataset, "xi0");
    spectrum.nodes = numbers(dataset, "wavenumbers");
    const bool fits = three == 3 && pairs == spectrum.component_size() && nodes == spectrum.nodes.size() &&
                      nodes >= 5 && nodes <= most_nodes && spectrum.nodes.front() == 0 && spectrum.xi0 > 0 &&
                      std::ranges::is_sorted(spectrum.nodes) &&
                      std::ranges::all_of(spectrum.values, [](double value) { return std::isfinite(value); });
    if (!fits) throw DamagedTable("The transform of the file is not that of a section.");
    for (std::size_t column = 0; column < columns; ++column)
        spectrum.frames.push_back({frames[3 * column], frames[3 * column + 1], frames[3 * column + 2]});
    return spectrum;
}

}  // namespace contactd

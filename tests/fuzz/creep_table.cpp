// Files of creep-force tables. The input is a header, and doubles behind it: a/b and three creepages each. The target
// completes a valid header to a file with a right digest, so that ranges and evaluation are reached.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"
#include "creep_table/evaluate.hpp"
#include "creep_table/file/file_header.hpp"
#include "input.hpp"
#include "store/sha256.hpp"

namespace {

using namespace contactd;
using namespace contactd::creep_table;

constexpr std::uint64_t largest = 1 << 20;

/// Returns the file of a header, all of whose numbers are 1 in single precision, or the input if its sizes are invalid.
std::vector<unsigned char> completed(const std::uint8_t* data, std::size_t size) {
    std::vector<unsigned char> bytes(data, data + size);
    FileHeader header;
    if (size < sizeof header) return bytes;
    std::memcpy(static_cast<void*>(&header), data, sizeof header);
    if (!sizes_are_valid(header) || offsets_of(header).end > largest) return bytes;
    const FileOffsets at = offsets_of(header);
    header.file_size = at.end;
    bytes.resize(static_cast<std::size_t>(at.end));
    std::memcpy(bytes.data(), &header, sizeof header);
    const float one = 1;
    for (std::size_t k = sizeof header; k + sizeof one <= at.digest; k += sizeof one)
        std::memcpy(bytes.data() + k, &one, sizeof one);
    const std::string digest = sha256_hex(std::span(bytes).first(static_cast<std::size_t>(at.digest)));
    std::memcpy(bytes.data() + at.digest, digest.data(), digest.size());
    return bytes;
}

CreepSpline first_of(const CreepFile& file) {
    const std::size_t count = file.nu.size();
    CreepSpline spline{file.grid, file.curve_axis(), file.curves.first(file.curves.size() / count),
                       file.coefficients.first(file.coefficients.size() / count), file.box};
    spline.box_coefficients = file.box_coefficients.first(file.box_coefficients.size() / count);
    spline.bound_axes = file.bound_axes();
    spline.bounds = file.bounds;
    return spline;
}

void evaluate_at(const CreepSpline& spline, const double (&state)[4]) {
    const SplineAxis& axis = spline.grid.axes[log_ratio];
    const double ratio = std::isfinite(state[0]) ? std::clamp(state[0], axis.from, axis.to) : axis.from;
    try {
        (void)evaluate(spline, ratio, {state[1], state[2], state[3]});
    } catch (const InvalidArgument&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::vector<unsigned char> bytes = completed(data, size);
        const CreepSpline spline = first_of(parse_creep_file(bytes, "the file"));
        double state[4];
        for (std::size_t k = sizeof(FileHeader); k + sizeof state <= size; k += sizeof state) {
            std::memcpy(state, data + k, sizeof state);
            evaluate_at(spline, state);
        }
    } catch (const StoreError&) {
    }
    return 0;
}

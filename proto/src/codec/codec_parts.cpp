#include "codec_parts.hpp"
#include "contactd/proto/object.hpp"

#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_grid(const Grid& grid) {
    json result = object(
        {{"nx", grid.nx}, {"ny", grid.ny}, {"dx", finite(grid.dx, "grid.dx")}, {"dy", finite(grid.dy, "grid.dy")}});
    const Grid centred = Grid::of_elements(grid.nx, grid.ny, grid.dx, grid.dy);
    if (grid.x0 != centred.x0) result["x0"] = finite(grid.x0, "grid.x0");
    if (grid.y0 != centred.y0) result["y0"] = finite(grid.y0, "grid.y0");
    return result;
}

int decode_count(const json& grid, const char* name) {
    const auto count = grid[name].get<long long>();
    if (count > static_cast<long long>(max_grid_elements))
        throw invalid_field(
            "grid." + std::string(name),
            "is " + std::to_string(count) + "; nx times ny must not exceed " + std::to_string(max_grid_elements),
            reason::limit_exceeded);
    return static_cast<int>(count);
}

Grid decode_grid(const json& source) {
    Grid grid = Grid::of_elements(decode_count(source, "nx"), decode_count(source, "ny"), source["dx"].get<double>(),
                                  source["dy"].get<double>());
    grid.x0 = source.value("x0", grid.x0);
    grid.y0 = source.value("y0", grid.y0);
    // This check precedes any allocation of the claimed size.
    try {
        validate(grid, "grid");
    } catch (const InvalidArgument& error) {
        throw invalid_field(error.field(), error.problem());
    }
    return grid;
}

std::vector<std::size_t> claimed_shape(const json& array, std::size_t most_axes) {
    if (array.is_object()) return array["$array"]["shape"].get<std::vector<std::size_t>>();
    std::vector<std::size_t> shape;
    for (const json* list = &array; list->is_array() && shape.size() < most_axes; list = &list->front()) {
        shape.push_back(list->size());
        if (list->empty()) break;
    }
    return shape;
}

}  // namespace contactd::proto

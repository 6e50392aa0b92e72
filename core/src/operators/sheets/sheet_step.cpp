#include "sheet_step.hpp"

#include <algorithm>
#include <utility>

#include "operators/coarsening.hpp"
#include "operators/upstream.hpp"

namespace contactd {

SheetStep::SheetStep(std::shared_ptr<const StepOperator> bodies, const Grid& grid, double step_x, double step_y,
                     double flexibility)
    : bodies_(std::move(bodies)),
      grid_(grid),
      step_x_(step_x),
      step_y_(step_y),
      flexibility_(flexibility),
      neighbours_(elements_ahead(grid, step_x, step_y)) {}

void SheetStep::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                           std::span<double> uy) const {
    bodies_->tangential(px, py, ux, uy);
    add_sheet(px, ux);
    add_sheet(py, uy);
}

void SheetStep::add_sheet(std::span<const double> p, std::span<double> u) const {
    for (std::size_t i = 0; i < p.size(); ++i) u[i] += flexibility_ * p[i];
    for (const ElementAhead& ahead : neighbours_) {
        const double factor = flexibility_ * ahead.weight;
        const int from_x = std::max(0, -ahead.x), to_x = std::min(grid_.nx, grid_.nx - ahead.x);
        const int from_y = std::max(0, -ahead.y), to_y = std::min(grid_.ny, grid_.ny - ahead.y);
        for (int iy = from_y; iy < to_y; ++iy) {
            double* here = &u[static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid_.nx)];
            const double* there = &p[static_cast<std::size_t>(iy + ahead.y) * static_cast<std::size_t>(grid_.nx)];
            for (int ix = from_x; ix < to_x; ++ix) here[ix] -= factor * there[ix + ahead.x];
        }
    }
}

std::shared_ptr<const StepOperator> SheetStep::on(const ElementBox& box) const {
    std::shared_ptr<const StepOperator> part = bodies_->on(box);
    if (!part) return nullptr;
    Grid grid = grid_;
    grid.nx = box.nx;
    grid.ny = box.ny;
    return std::make_shared<const SheetStep>(std::move(part), grid, step_x_, step_y_, flexibility_);
}

const StepOperator* SheetStep::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const StepOperator> {
        const StepOperator* bodies = bodies_->coarser();
        if (bodies == nullptr) return nullptr;
        const Coarsening larger(grid_.nx, grid_.ny);
        Grid grid = grid_;
        grid.dx *= larger.along_x();
        grid.dy *= larger.along_y();
        grid.nx = (grid.nx + larger.along_x() - 1) / larger.along_x();
        grid.ny = (grid.ny + larger.along_y() - 1) / larger.along_y();
        if (grid.size() != bodies->size()) return nullptr;
        const std::shared_ptr<const StepOperator> borrowed(std::shared_ptr<void>(), bodies);
        return std::make_unique<const SheetStep>(borrowed, grid, step_x_, step_y_, flexibility_);
    };
    return coarser_.get(make).get();
}

}  // namespace contactd

#include "influence_division.hpp"

#include <algorithm>
#include <cstring>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr double sweep_self = 1.5;      // times the self-influence: that of an element with its close neighbours
constexpr double stiff_self = 2;        // times the self-influence: tangent stiffness that dominates the Jacobian
constexpr int margin = 2;               // in elements around adhesion
constexpr std::size_t much_larger = 2;  // factor on the best box above which a new one pays

bool is_within(const ElementBox& inner, const ElementBox& outer) {
    return united(inner, outer) == outer;
}

ElementBox grown(const ElementBox& box, const ElementBox& extent) {
    const int left = std::max(box.first_x - margin, 0), bottom = std::max(box.first_y - margin, 0);
    return {left, bottom, std::min(box.first_x + box.nx + margin, extent.nx) - left,
            std::min(box.first_y + box.ny + margin, extent.ny) - bottom};
}

}  // namespace

InfluenceDivision::InfluenceDivision(const InfluenceOperator& influence, const Contact& contact,
                                     const std::vector<double>& self, double diagonal_of_transport)
    : influence_(influence),
      contact_(contact),
      weight_(contact.size()),
      diagonal_(contact.size()),
      along_flow_(self, stiff_self, sweep_self) {
    stiff_.reserve(self.size());
    to_diagonal_.reserve(self.size());
    for (const double value : self) {
        stiff_.push_back(stiff_self * value * diagonal_of_transport);
        to_diagonal_.push_back(1 / (sweep_self * value));
    }
    take(extent_of(influence));
}

void InfluenceDivision::linearise(const Linearisation& law) {
    shifted_reciprocal(weight_.size(), law.tangent_stiffness.data(), stiff_.data(), stiff_.data(), weight_.data());
    for (std::size_t e = 0; e < weight_.size(); ++e) diagonal_[e] = (1 - weight_[e] * weight_[e]) * to_diagonal_[e];
    law_ = &law;
    if (!law.flow) return;
    along_flow_.linearise(*law.flow);
    if (rows_.x.empty()) rows_ = rest_ = Field(weight_.size());
}

bool InfluenceDivision::take_all() {
    if (box_->is_whole()) return false;
    take(extent_of(influence_));
    return true;
}

bool InfluenceDivision::take_adhesion(const std::vector<char>& slips) {
    const ElementBoxes* boxes = influence_.boxes();
    if (boxes == nullptr) return false;
    const ElementBox needed = grown(box_of_adhesion(slips), boxes->extent()), best = boxes->convenient(needed, false),
                     now = box_->box();
    if (best == now || (is_within(needed, now) && now.size() <= much_larger * best.size())) return false;
    take(needed);
    return true;
}

// Searches row by row; a run of adjacent elements may continue in the next row.
ElementBox InfluenceDivision::box_of_adhesion(const std::vector<char>& slips) const {
    const auto nx = static_cast<std::size_t>(extent_of(influence_).nx);
    ElementBox all{};
    for (const Contact::Run& run : contact_.runs)
        for (std::size_t i = 0, size = 0; i < run.size; i += size) {
            const std::size_t ix = (run.grid_first + i) % nx, iy = (run.grid_first + i) / nx;
            size = std::min(run.size - i, nx - ix);
            const char* row = &slips[run.first + i];
            const void* found = std::memchr(row, 0, size);
            if (found == nullptr) continue;
            const auto first = static_cast<std::size_t>(static_cast<const char*>(found) - row);
            std::size_t last = size - 1;
            while (row[last] != 0) --last;
            const ElementBox here{static_cast<int>(ix + first), static_cast<int>(iy),
                                  static_cast<int>(last - first + 1), 1};
            all = all.nx == 0 ? here : united(all, here);
        }
    return all;
}

void InfluenceDivision::take(const ElementBox& needed) {
    box_.emplace(influence_, needed, false);
    const ElementBox &box = box_->box(), extent = extent_of(influence_);
    full_in_ = Field(box.size());
    full_out_ = Field(box.size());
    if (box_->is_whole()) {
        runs_ = contact_.runs;
        return;
    }
    runs_.clear();
    for (std::size_t e = 0; e < contact_.size(); ++e) {
        const std::size_t i = contact_.elements[e], nx = static_cast<std::size_t>(extent.nx);
        if (!box_->contains(i)) continue;
        const std::size_t at = (i / nx - static_cast<std::size_t>(box.first_y)) * static_cast<std::size_t>(box.nx) +
                               i % nx - static_cast<std::size_t>(box.first_x);
        if (!runs_.empty() && runs_.back().first + runs_.back().size == e &&
            runs_.back().grid_first + runs_.back().size == at)
            ++runs_.back().size;
        else
            runs_.push_back({e, at, 1});
    }
}

void InfluenceDivision::divide_with_flow(const Field& r, Field& q) {
    rest_ = r;
    along_flow_.scale_rows(weight_, r, rows_);
    contact_.scatter(rows_.x, full_in_.x);
    contact_.scatter(rows_.y, full_in_.y);
    box_->influence().precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    contact_.gather(full_out_.x, q.x);
    contact_.gather(full_out_.y, q.y);
    along_flow_.complete(weight_, diagonal_, rest_, q);
}

void InfluenceDivision::divide(const Field& r, Field& q) {
    if (law_->flow) return divide_with_flow(r, q);
    const auto scatter = [&](const std::vector<double>& from, std::vector<double>& to) {
        for (const Contact::Run& run : runs_)
            multiply(run.size, &weight_[run.first], &from[run.first], &to[run.grid_first]);
    };
    const auto gather = [&](const std::vector<double>& from, const std::vector<double>& rest, std::vector<double>& to) {
        for (const Contact::Run& run : runs_)
            multiply_two(run.size, &weight_[run.first], &from[run.grid_first], &diagonal_[run.first], &rest[run.first],
                         &to[run.first]);
    };
    scatter(r.x, full_in_.x);
    scatter(r.y, full_in_.y);
    if (!box_->is_whole() && &r != &q) {
        multiply(diagonal_.size(), diagonal_.data(), r.x.data(), q.x.data());
        multiply(diagonal_.size(), diagonal_.data(), r.y.data(), q.y.data());
    }
    box_->influence().precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    gather(full_out_.x, r.x, q.x);
    gather(full_out_.y, r.y, q.y);
}

}  // namespace contactd

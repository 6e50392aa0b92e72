// Finds the positions of rolling particles one step ago among the elements in contact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

// Describes an element of the grid used in bilinear interpolation, by its position relative to that of a particle now.
struct ElementAhead {
    int x, y;
    double weight;
};
// Returns the elements around the point one step ahead, whose weights sum to 1.
std::vector<ElementAhead> elements_ahead(const Grid& grid, double step_x, double step_y);

// Orders elements so that those from which particles come precede those that they reach. Each has the elements ahead of
// it that bilinear interpolation uses, and their weights.
class Upstream {
   public:
    struct Link {
        std::size_t element;  // index ahead; the number of elements if that is outside the contact
        double weight;
    };

    // `elements` of the grid are ascending; the way back is (step_x, step_y), not both zero.
    Upstream(const Grid& grid, double step_x, double step_y, std::span<const std::size_t> elements);

    std::size_t size() const { return order_.size(); }
    const std::vector<std::size_t>& order() const { return order_; }
    std::size_t links() const { return links_; }  // per element
    // Returns links of shape [size(), links()], in the order.
    const std::vector<Link>& ahead() const { return ahead_; }
    // Returns the weight of an element's own value after the interpolation, below 1 if a step is shorter than an
    // element.
    double diagonal() const { return diagonal_; }

    // Computes values that travel with the particles from leading to trailing edges: value(e, v) is that behind element
    // e for an incoming v; particles enter with `entering`. A step shorter than an element mixes in the value behind
    // it.
    template <class Value>
    void travel(double entering, const Value& value, std::vector<double>& behind) const {
        const Link* link = ahead_.data();
        for (const std::size_t e : order_) {
            double sum = 0;
            for (std::size_t j = 0; j < links_; ++j, ++link)
                sum += link->weight * (link->element < size() ? behind[link->element] : entering);
            behind[e] = value(e, sum / diagonal_);
        }
    }

   private:
    std::vector<std::size_t> order_;
    std::size_t links_ = 0;
    std::vector<Link> ahead_;
    double diagonal_ = 1;
};

// Returns values of a grid at the point one step ahead of each element, by bilinear interpolation, with `entering`
// beyond the grid.
std::vector<double> one_step_ahead(const Grid& grid, double step_x, double step_y, std::span<const double> values,
                                   double entering);

}  // namespace contactd

// Where the particles of rolling were one step ago, among the elements in contact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

// An element of the grid that bilinear interpolation takes, by its place from the one where a particle is now.
struct ElementAhead {
    int x, y;
    double weight;
};
// The elements around the place one step ahead, whose weights sum to 1.
std::vector<ElementAhead> elements_ahead(const Grid& grid, double step_x, double step_y);

// Elements in an order in which those that particles come from stand before those they reach, each with the elements
// ahead of it that bilinear interpolation takes, and their weights.
class Upstream {
   public:
    struct Link {
        std::size_t element;  // ahead; the number of elements where that is outside contact
        double weight;
    };

    // `elements` of the grid, ascending; the way back is (step_x, step_y), not both zero.
    Upstream(const Grid& grid, double step_x, double step_y, std::span<const std::size_t> elements);

    std::size_t size() const { return order_.size(); }
    const std::vector<std::size_t>& order() const { return order_; }
    std::size_t links() const { return links_; }  // per element
    // Shape [size(), links()], in the order.
    const std::vector<Link>& ahead() const { return ahead_; }
    // What interpolation leaves of an element's own value: below 1 where a step is shorter than an element.
    double diagonal() const { return diagonal_; }

    // Takes what travels with the particles from leading to trailing edges: value(e, v) is that behind element e where
    // v came to it; particles enter with `entering`. A step shorter than an element mixes in the value behind it.
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

// Values of a grid at the place one step ahead of each element, by bilinear interpolation; `entering` beyond the grid.
std::vector<double> one_step_ahead(const Grid& grid, double step_x, double step_y, std::span<const double> values,
                                   double entering);

}  // namespace contactd

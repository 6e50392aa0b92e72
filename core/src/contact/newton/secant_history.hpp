// Least squares over the steps an iteration has made: of their combinations, the one that lowers a linearised residual
// most (Anderson 1965; for a linear problem the iteration becomes GMRES).
#pragma once

#include <memory>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contact/support/pair.hpp"

namespace contactd {

// A vector field on the elements of the contact, somewhere in memory.
using FieldView = MutableVectors;

// Steps are changes of the tractions, and of the uniform rigid slip where that is unknown, too. Residuals are fields,
// and two numbers for the forces that are missing. Both pairs are zero where no forces are given.
class SecantHistory {
   public:
    SecantHistory(std::size_t m, std::size_t capacity);

    // All steps so far stay for good.
    void hold() { permanent_ = size_; }
    void clear();
    std::size_t size() const { return size_ - permanent_; }  // without those that stay

    // A new step and its response; the oldest one goes when there is no room. Write to both before accept().
    FieldView new_step() { return view(slot(size_), step_part); }
    FieldView new_response() { return view(slot(size_), response_part); }
    void accept(const Pair& rigid);

    // forces_j, image_j = f(step_j, response_j, rigid_j), for all steps or for the newest only, and their inner
    // products.
    template <class F>
    void map_all(const F& f) {
        for (std::size_t j = 0; j < size_; ++j) {
            map(j, f);
            update_products(j);
        }
        knows_newest_ = true;
    }
    template <class F>
    void map_newest(const F& f) {
        if (size_ > 0) map(size_ - 1, f);
        knows_newest_ = false;  // minimise() reads all images anyway
    }

    // r -> r - sum c_j image_j and forces -> forces - sum c_j forces_j of least length together; d = sum c_j step_j.
    // Returns sum c_j rigid_j.
    Pair minimise(Field& r, Pair& forces, Field& d);
    // slip -> slip + sum c_j response_j with the c_j of the last minimise(): what d does, without a product.
    void add_responses(Field& slip) const { add(response_part, 1, slip); }

   private:
    enum Part : std::size_t { step_part, response_part, image_part, parts };

    // Behind the steps that stay the others go round.
    std::size_t slot(std::size_t j) const {
        return j < permanent_ ? j : permanent_ + (first_ + j - permanent_) % (capacity_ - permanent_);
    }
    FieldView view(std::size_t slot_index, Part part) const {
        double* x = values_.get() + (slot_index * parts + part) * 2 * m_;
        return {x, x + m_};
    }
    template <class F>
    void map(std::size_t j, const F& f) {
        const std::size_t at = slot(j);
        forces_[at] = f(view(at, step_part), view(at, response_part), rigid_[at], view(at, image_part));
    }
    void update_products(std::size_t j);
    // image_j . r, and where it is not known yet, image_j . image_newest.
    double product_with(std::size_t slot_index, const Field& r, const Pair& forces);
    void add(Part part, double sign, Field& to) const;
    double& product(std::size_t a, std::size_t b) { return products_[a * capacity_ + b]; }

    std::size_t m_, capacity_, size_ = 0, permanent_ = 0, first_ = 0;
    // Slots, one more than used: the new one is written there. One block that is not filled: most solves use little.
    std::unique_ptr<double[]> values_;
    std::vector<Pair> rigid_, forces_;  // of steps and of images, by slots
    std::vector<double> products_;      // by slots
    bool knows_newest_ = true;          // their products with the newest image
    std::vector<double> factor_, right_, scale_;
    std::vector<std::size_t> used_;
};

}  // namespace contactd

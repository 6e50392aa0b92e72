// Combines the previous steps of an iteration by least squares, so that a linearised residual becomes smallest
// (Anderson 1965; for a linear problem the iteration becomes GMRES).
#pragma once

#include <memory>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contact/support/pair.hpp"

namespace contactd {

// Refers to a vector field on the elements of the contact.
using FieldView = MutableVectors;

// Steps are changes of the tractions, and of the uniform rigid slip if that is unknown, too. Residuals are fields and
// two numbers for the missing forces. Both pairs are zero without prescribed forces.
class SecantHistory {
   public:
    SecantHistory(std::size_t m, std::size_t capacity);

    // Keeps all current steps permanently.
    void hold() { permanent_ = size_; }
    void clear();
    std::size_t size() const { return size_ - permanent_; }  // without permanent steps

    // Return storage for a new step and its response; the oldest step is dropped if there is no space. Write to both
    // before accept().
    FieldView new_step() { return view(slot(size_), step_part); }
    FieldView new_response() { return view(slot(size_), response_part); }
    void accept(const Pair& rigid);

    // Computes forces_j, image_j = f(step_j, response_j, rigid_j), for all steps or for the newest only, and their
    // inner products.
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
        knows_newest_ = false;  // because minimise() reads all images anyway
    }

    // Changes r to r - sum c_j image_j and forces to forces - sum c_j forces_j, of smallest length together, and sets d
    // = sum c_j step_j. Returns sum c_j rigid_j.
    Pair minimise(Field& r, Pair& forces, Field& d);
    // Changes slip to slip + sum c_j response_j with the c_j of the last minimise(), which is the effect of d without a
    // product.
    void add_responses(Field& slip) const { add(response_part, 1, slip); }

   private:
    enum Part : std::size_t { step_part, response_part, image_part, parts };

    // Returns the slot of a step: behind the permanent steps, the others form a ring.
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
    // Returns image_j . r, and computes image_j . image_newest if it is unknown.
    double product_with(std::size_t slot_index, const Field& r, const Pair& forces);
    void add(Part part, double sign, Field& to) const;
    double& product(std::size_t a, std::size_t b) { return products_[a * capacity_ + b]; }

    std::size_t m_, capacity_, size_ = 0, permanent_ = 0, first_ = 0;
    // There is one slot more than used, for the new step. The block is not initialised, because most solves use little
    // of it.
    std::unique_ptr<double[]> values_;
    std::vector<Pair> rigid_, forces_;  // values of steps and of images, by slots
    std::vector<double> products_;      // by slots
    bool knows_newest_ = true;          // whether products with the newest image are known
    std::vector<double> factor_, right_, scale_;
    std::vector<std::size_t> used_;
};

}  // namespace contactd

// Sums gradients for a given approach and motion.
#pragma once

#include <vector>

#include "adjoint.hpp"
#include "elastic_slip.hpp"
#include "material_gradients.hpp"

namespace contactd {

// Holds the gradient of an output by everything that may be an input, of which only requested ones are filled.
struct GradientOfKnownMotion {
    double approach = 0, along_x = 0, along_y = 0, about_z = 0;
    std::vector<double> gap, mu;
    Field rigid_slip;
    GradientByMaterial upper, lower;
    GradientByPrevious previous;

    // Adds a multiple of another gradient.
    void add(const GradientOfKnownMotion& other, double factor);
};

// Converts adjoints to gradients by approach, motion, gap, friction and rigid slip.
GradientOfKnownMotion gradient_of(const ContactProblem& problem, const ContactSolution& solution,
                                  const OutputWeights& weights, const Adjoint& adjoint);

}  // namespace contactd

// Rotates fields between rows of elements with different normals, on half-spaces along the loaded row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace contactd {

/// Holds components along s (of a row, across x) and z (its normal) of fields on all elements of a grid.
struct RowComponents {
    std::vector<double> s, z;

    explicit RowComponents(std::size_t size) : s(size), z(size) {}
};

/// With Q a rotation by a right angle and a the angle of a row, displacements are rotated from the axes of the loaded
/// row J to those of the observed row I by the product of T(a_I) and T(-a_J) = cos a_J - sin a_J Q. Therefore, those of
/// all rows are two convolutions of tractions multiplied by the cosines and by the sines of their rows: u = T(a_I) (A
/// (cos p) - Q A (sin p)).
class RowRotations {
   public:
    /// Angles (rad) are those of the normals, which lean towards +s if positive, by rows of nx elements.
    RowRotations(std::span<const double> angles, int nx);

    std::size_t size() const { return cosine_.size() * nx_; }
    RowRotations on(int first_row, int rows, int nx) const;
    /// Returns the rotations of rows that represent groups of neighbours, by their mean angle. The last group may
    /// extend beyond the grid.
    RowRotations coarse(int along_x, int along_y) const;

    std::vector<double> times_cosine(std::span<const double> values) const { return times(cosine_, values); }
    std::vector<double> times_sine(std::span<const double> values) const { return times(sine_, values); }
    /// Computes displacements along z of the observed rows from displacements by tractions times cosines and times
    /// sines.
    void along_z(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> z) const;
    /// Computes displacements along s in the same way.
    void along_s(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> s) const;

   private:
    std::vector<double> times(const std::vector<double>& factor, std::span<const double> values) const;

    std::size_t nx_;
    std::vector<double> angles_, cosine_, sine_;  // of each row
};

}  // namespace contactd

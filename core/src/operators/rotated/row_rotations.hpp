// Rows of elements whose normals have angles of their own, on half-spaces that lie along the loaded row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace contactd {

/// Components along s (of a row, across x) and z (its normal) of fields on all elements of a grid.
struct RowComponents {
    std::vector<double> s, z;

    explicit RowComponents(std::size_t size) : s(size), z(size) {}
};

/// With Q for a right angle and a = sin and cos of a row's angle, displacements are turned from the axes of the loaded
/// row J to those of the observed row I by the product of T(a_I) and T(-a_J) = cos a_J - sin a_J Q. So those of all
/// rows are two convolutions of tractions that are multiplied by the cosines and by the sines of their rows:
/// u = T(a_I) (A (cos p) - Q A (sin p)).
class RowRotations {
   public:
    /// Angles (rad) of the normals, which lean towards +s where they are positive, by rows of nx elements.
    RowRotations(std::span<const double> angles, int nx);

    std::size_t size() const { return cosine_.size() * nx_; }
    RowRotations on(int first_row, int rows, int nx) const;
    /// Returns those of rows that stand for so many neighbours each, by their mean angle. The last may reach beyond.
    RowRotations coarse(int along_x, int along_y) const;

    std::vector<double> times_cosine(std::span<const double> values) const { return times(cosine_, values); }
    std::vector<double> times_sine(std::span<const double> values) const { return times(sine_, values); }
    /// Displacements along z of the observed rows: of those from tractions times cosines and times sines.
    void along_z(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> z) const;
    /// Displacements along s, likewise.
    void along_s(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> s) const;

   private:
    std::vector<double> times(const std::vector<double>& factor, std::span<const double> values) const;

    std::size_t nx_;
    std::vector<double> angles_, cosine_, sine_;  // of each row
};

}  // namespace contactd

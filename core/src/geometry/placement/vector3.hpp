// Defines vectors and rotations of three-dimensional space.
#pragma once

#include <cmath>

namespace contactd::geometry {

struct Vector3 {
    double x = 0, y = 0, z = 0;

    friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector3 operator*(double factor, const Vector3& a) { return {factor * a.x, factor * a.y, factor * a.z}; }
};

inline double dot(const Vector3& a, const Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The columns are the rotated axes.
struct Rotation {
    Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    Vector3 operator*(const Vector3& a) const { return a.x * x + a.y * y + a.z * z; }
    Rotation operator*(const Rotation& inner) const { return {*this * inner.x, *this * inner.y, *this * inner.z}; }
    Vector3 rotated_back(const Vector3& a) const { return {dot(x, a), dot(y, a), dot(z, a)}; }

    /// Returns the rotation about x, from y to z.
    static Rotation roll(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
    }
    /// Returns the rotation about z, from x to y, and then about x.
    static Rotation yaw_then_roll(double yaw, double roll_angle) {
        const double c = std::cos(yaw), s = std::sin(yaw);
        const Rotation rolled = roll(roll_angle);
        return {c * rolled.x + s * rolled.y, c * rolled.y - s * rolled.x, rolled.z};
    }
};

/// Describes a frame of axes in another.
struct Frame {
    Vector3 origin{};
    Rotation axes{};

    Vector3 outside(const Vector3& inside) const { return origin + axes * inside; }
    Vector3 inside(const Vector3& outside) const { return axes.rotated_back(outside - origin); }
};

}  // namespace contactd::geometry

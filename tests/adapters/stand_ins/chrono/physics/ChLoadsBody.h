// Replaces the part of Project Chrono 9 that wheelset_on_track.hpp uses, with the names and arguments of its headers
// ChLoadsBody.h, ChFrameMoving.h and ChVector3.h. Chrono is not among the packages.
#pragma once

#include <array>
#include <memory>

namespace chrono {

class ChVector3d {
   public:
    ChVector3d(double x = 0, double y = 0, double z = 0) : values_{x, y, z} {}
    double x() const { return values_[0]; }
    double y() const { return values_[1]; }
    double z() const { return values_[2]; }

   private:
    std::array<double, 3> values_;
};

template <class Real = double>
class ChMatrix33 {
   public:
    std::array<Real, 9> values{1, 0, 0, 0, 1, 0, 0, 0, 1};
    Real operator()(int row, int column) const { return values[3 * row + column]; }
};

template <class Real = double>
class ChFrame {
   public:
    const ChVector3d& GetPos() const { return place; }
    const ChMatrix33<Real>& GetRotMat() const { return rotation; }

    ChVector3d place;
    ChMatrix33<Real> rotation;
};

template <class Real = double>
class ChFrameMoving : public ChFrame<Real> {
   public:
    const ChVector3d& GetPosDt() const { return velocity; }
    ChVector3d GetAngVelParent() const { return omega; }

    ChVector3d velocity, omega;
};

class ChBody {};

class ChLoadBase {
   public:
    virtual ~ChLoadBase() = default;
    virtual ChLoadBase* Clone() const = 0;
    virtual bool IsStiff() = 0;
};

class ChLoadBodyBody : public ChLoadBase {
   public:
    ChLoadBodyBody(std::shared_ptr<ChBody> bodyA, std::shared_ptr<ChBody> bodyB, const ChFrame<>& abs_application)
        : a_(std::move(bodyA)), b_(std::move(bodyB)), application_(abs_application) {}

    virtual void ComputeBodyBodyForceTorque(const ChFrameMoving<>& rel_AB, ChVector3d& loc_force,
                                            ChVector3d& loc_torque) = 0;

   private:
    std::shared_ptr<ChBody> a_, b_;
    ChFrame<> application_;
};

}  // namespace chrono

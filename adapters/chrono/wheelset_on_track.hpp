// Implements a wheelset on its rails in Project Chrono 9, as a load between the body of the wheelset and the body of
// the track.
//
//     auto contact = std::make_shared<WheelsetOnTrack>(wheelset, ground, frame, "local", "fastsim", 0.3, 1e-3);
//     container->Add(contact);   // a ChLoadContainer of the system
//
// `frame`, in absolute coordinates, has the axes of the track: x forwards, y to the right, z down. Its origin is at the
// wheelset's centre when its tape circles stand on the plane of the rail tops. The wheelset's axle is along its y axis.
// Units are SI. Chrono computes the Jacobian by differences.
#pragma once

#include "contactd_wheelset.h"

#include "chrono/physics/ChLoadsBody.h"

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

class WheelsetOnTrack : public chrono::ChLoadBodyBody {
   public:
    /// Throws std::runtime_error with contactd's message if the wheels cannot be created.
    WheelsetOnTrack(std::shared_ptr<chrono::ChBody> wheelset, std::shared_ptr<chrono::ChBody> ground,
                    const chrono::ChFrame<>& frame, const std::string& where, const std::string& model, double friction,
                    double element)
        : ChLoadBodyBody(wheelset, ground, frame), wheels_(opened(where, model, friction, element)) {}

    /// Copies share the wheels. Their steps affect each other's results only within the tolerances.
    WheelsetOnTrack* Clone() const override { return new WheelsetOnTrack(*this); }

    /// Returns both wheels, to set profiles and other fields by the paths of contactd.h.
    contactd_wheelset& wheels() const { return *wheels_; }

   protected:
    bool IsStiff() override { return true; }

    /// Computes the force on the track, in its axes; Chrono applies the opposite to the wheelset.
    void ComputeBodyBodyForceTorque(const chrono::ChFrameMoving<>& rel_AB, chrono::ChVector3d& loc_force,
                                    chrono::ChVector3d& loc_torque) override {
        const auto& matrix = rel_AB.GetRotMat();
        const auto &at = rel_AB.GetPos(), &speed = rel_AB.GetPosDt();
        const auto spin = rel_AB.GetAngVelParent();
        const double place[] = {at.x(), at.y(), at.z()}, velocity[] = {speed.x(), speed.y(), speed.z()};
        const double omega[] = {spin.x(), spin.y(), spin.z()};
        double rotation[9], force[3], moment[3];
        for (int k = 0; k < 9; ++k) rotation[k] = matrix(k / 3, k % 3);
        check(contactd_wheelset_solve(wheels_.get(), place, rotation, velocity, omega, force, moment));
        loc_force = chrono::ChVector3d(-force[0], -force[1], -force[2]);
        loc_torque = chrono::ChVector3d(-moment[0], -moment[1], -moment[2]);
    }

   private:
    static void check(std::int32_t code) {
        if (code != CONTACTD_OK) throw std::runtime_error(contactd_last_error(nullptr));
    }

    static std::shared_ptr<contactd_wheelset> opened(const std::string& where, const std::string& model,
                                                     double friction, double element) {
        std::shared_ptr<contactd_wheelset> wheels(new contactd_wheelset, [](contactd_wheelset* of) {
            contactd_wheelset_close(of);
            delete of;
        });
        check(contactd_wheelset_open(wheels.get(), where.c_str(), model.c_str(), friction, element));
        return wheels;
    }

    std::shared_ptr<contactd_wheelset> wheels_;
};

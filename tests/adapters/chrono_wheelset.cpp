// Applies motions of a wheelset from a file, in the format of stand_ins/mbc.h, to the load of wheelset_on_track.hpp,
// and prints its force on the track.
#include "wheelset_on_track.hpp"

#include <fstream>
#include <iomanip>
#include <iostream>

namespace {

chrono::ChVector3d vector_of(std::istream& in) {
    double x, y, z;
    in >> x >> y >> z;
    return {x, y, z};
}

}  // namespace

int main(int, char** arguments) {
    std::ifstream motions(arguments[1]);
    auto body = std::make_shared<chrono::ChBody>(), ground = std::make_shared<chrono::ChBody>();
    try {
        WheelsetOnTrack first(body, ground, chrono::ChFrame<>(), arguments[2], arguments[3], 0.3, 1e-3);
        const std::unique_ptr<WheelsetOnTrack> copy(first.Clone());
        chrono::ChLoadBodyBody& load = *copy;
        std::cout << std::setprecision(17);
        while (motions.peek() != EOF) {
            chrono::ChFrameMoving<> frame;
            frame.place = vector_of(motions);
            for (int k = 0; k < 9; ++k) motions >> frame.rotation.values[3 * (k % 3) + k / 3];
            frame.velocity = vector_of(motions);
            frame.omega = vector_of(motions);
            motions >> std::ws;
            chrono::ChVector3d force, torque;
            load.ComputeBodyBodyForceTorque(frame, force, torque);
            std::cout << force.x() << ' ' << force.y() << ' ' << force.z() << ' ' << torque.x() << ' ' << torque.y()
                      << ' ' << torque.z() << '\n';
        }
    } catch (const std::runtime_error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

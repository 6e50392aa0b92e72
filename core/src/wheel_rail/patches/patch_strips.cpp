#include "contactd/patch_strips.hpp"

namespace contactd {

ContactColumns strips_of(const ContactPlace& place) {
    ContactColumns strips{{}, -place.reference.angle, {place.reference.y, place.reference.z}};
    for (const ContactRow& row : place.rows) strips.frames.push_back({row.y, row.z, -row.angle});
    return strips;
}

}  // namespace contactd

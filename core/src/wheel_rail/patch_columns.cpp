#include "contactd/patch_columns.hpp"

namespace contactd {

ContactColumns columns_of(const ContactPlace& place) {
    ContactColumns columns{{}, -place.reference.angle, {place.reference.y, place.reference.z}};
    for (const ContactRow& row : place.rows) columns.frames.push_back({row.y, row.z, -row.angle});
    return columns;
}

}  // namespace contactd

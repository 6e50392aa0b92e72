#include "api_boundary.hpp"

#include "creep_tables.hpp"

namespace contactd::c {

Connections& connections() {
    static auto* const all = new Connections("connection", 1);
    return *all;
}

Contacts& contacts() {
    static auto* const all = new Contacts("contact", 3);
    return *all;
}

Wheels& wheels() {
    static auto* const all = new Wheels("wheel", 5);
    return *all;
}

CreepTables& creep_tables() {
    static auto* const all = new CreepTables;
    return *all;
}

}  // namespace contactd::c

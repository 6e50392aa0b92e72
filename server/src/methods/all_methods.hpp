// Lists every method of the wire, by families.
#pragma once

#include "method_table.hpp"

namespace contactd::server {

void add_server_methods(MethodTable& methods);        ///< server.*, health.watch
void add_ic_methods(MethodTable& methods);            ///< ic.*
void add_contact_methods(MethodTable& methods);       ///< contact.*
void add_wheelrail_methods(MethodTable& methods);     ///< wheelrail.*
void add_contact_file_methods(MethodTable& methods);  ///< contact_file.*
void add_session_methods(MethodTable& methods);       ///< session.*
void add_job_methods(MethodTable& methods);           ///< job.*, request.cancel
void add_solves_methods(MethodTable& methods);        ///< solves.*

inline MethodTable all_methods() {
    MethodTable methods;
    for (const auto add : {add_server_methods, add_ic_methods, add_contact_methods, add_wheelrail_methods,
                           add_contact_file_methods, add_session_methods, add_job_methods, add_solves_methods})
        add(methods);
    return methods;
}

}  // namespace contactd::server

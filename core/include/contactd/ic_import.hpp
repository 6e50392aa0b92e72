// Describes a table that a daemon has imported from a file.
#pragma once

#include "contactd/ic_reply.hpp"

namespace contactd {

struct IcImport {
    IcSpec spec;          ///< spec of the file; that of a longitudinally uniform body applies to any dx and nx
    IcUse use;            ///< its origin is "file", or "disk" if the daemon already had the table
    bool is_new = false;  ///< otherwise the daemon kept its own table
};

}  // namespace contactd

// A table that a daemon has taken over from a file.
#pragma once

#include "contactd/ic_reply.hpp"

namespace contactd {

struct IcImport {
    IcSpec spec;          ///< of the file; a longitudinally uniform body's is for any dx and nx
    IcUse use;            ///< its origin is "file", or "disk" where the daemon had the table already
    bool is_new = false;  ///< otherwise the daemon has kept its own
};

}  // namespace contactd

// What cases of one history owe to each other, and what digits and values of a case must be to be computed.
#pragma once

#include "groups.hpp"

namespace contactd::contact_files {

/// The cases of a result element, or of all without one, that keep data for each other.
struct History {
    ContactCase last;  ///< its digits and memory
    int cases = 0;     ///< that were read
    int failed = 0;    ///< number of the last case if it has errors, else 0
    int torn = 0;      ///< number of a case that was given up in the middle, so that what it left is not known; else 0
};

/// A history before its first case, with the defaults of the program.
History new_history(int module);

/// What digits do before the values are read: corrects those of a first case, and says in the errors of the case where
/// they do not go with each other or with the case before.
void apply_digits(Reading& reading, const History& history);
/// Tells whether a case reads all that it needs, so that no case before matters.
bool keeps_nothing(const Reading& reading);
/// What values do after they were read: what shifts and bodies alike leave in memory, and the errors of the case.
void apply_values(Reading& reading);

}  // namespace contactd::contact_files

// Rules for the digits and values of a case, and for data that cases of a history keep from each other.
#pragma once

#include "groups.hpp"

namespace contactd::contact_files {

/// Identifies the cases that keep data from each other: those of a result element, or all cases without one.
struct History {
    ContactCase last;  ///< digits and memory of the last case
    int cases = 0;     ///< number of cases read so far
    int failed = 0;    ///< number of the last case if it has errors, otherwise 0
    int torn = 0;      ///< number of a case whose reading was aborted, so that its data are unknown; otherwise 0
};

/// Returns a history before its first case, with CONTACT's defaults.
History new_history(int module);

/// Applies the digits before the values are read. Corrects the digits of a first case, and adds errors for digits that
/// are inconsistent with each other or with the previous case.
void apply_digits(Reading& reading, const History& history);
/// Returns whether a case reads all its data itself, so that previous cases have no effect.
bool keeps_nothing(const Reading& reading);
/// Applies the values after they were read. Sets the values that shifts and similar bodies imply, and adds errors.
void apply_values(Reading& reading);

}  // namespace contactd::contact_files

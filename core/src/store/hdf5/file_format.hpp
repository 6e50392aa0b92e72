// The format of IC files: which one this version writes, and what it says of others.
#pragma once

namespace contactd {

inline constexpr const char* format_name = "contactd_format";
inline constexpr long long format_version = 2;

/// Throws NewerFormat, or DamagedTable for an older one, of which nothing is read any more.
void check_format(long long found);

}  // namespace contactd

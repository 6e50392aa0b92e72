// Defines the format of IC files that this version writes, and how it treats other formats.
#pragma once

namespace contactd {

inline constexpr const char* format_name = "contactd_format";
inline constexpr long long format_version = 2;

/// Throws NewerFormat, or DamagedTable for an older format, which is no longer read.
void check_format(long long found);

}  // namespace contactd

// Describes the origin of a result: the versions of contactd and of the libraries that core uses.
#pragma once

#include <map>
#include <string>

namespace contactd {

std::string version();                                  ///< "0.1.0"
std::map<std::string, std::string> library_versions();  ///< name -> version, for libraries linked by contactd::core
std::string transform_library();                        ///< "ducc0 0.42.0": as chosen by the CMake option CONTACTD_FFT

}  // namespace contactd

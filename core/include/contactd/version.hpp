// The origin of a result: the version of contactd and of the libraries that core stands on.
#pragma once

#include <map>
#include <string>

namespace contactd {

std::string version();                                  ///< "0.1.0"
std::map<std::string, std::string> library_versions();  ///< name -> version, of what contactd::core links
std::string transform_library();                        ///< "ducc0 0.42.0": what CMake's option CONTACTD_FFT chose

}  // namespace contactd

// The origin of a result: the version of contactd and of the libraries that core stands on.
#pragma once

#include <map>
#include <string>
#include <utility>

namespace contactd {

std::string version();                                  ///< "0.1.0"
std::map<std::string, std::string> library_versions();  ///< name -> version, of what contactd::core links
/// Returns the name ("ducc0" or "fftw") and the version of the library that transforms: CMake's option CONTACTD_FFT.
std::pair<const char*, const char*> fft_library();

}  // namespace contactd

// Reads the contents of our HDF5 files. Anything that we do not write is refused before data are read.
#pragma once

#include <H5Cpp.h>

#include <cstddef>
#include <string>

#include "contactd/file_contents.hpp"

namespace contactd {

class Hdf5Reader {
   public:
    /// Data, links and texts together may not exceed the size of the file, `bytes`.
    explicit Hdf5Reader(std::size_t bytes) : bytes_(bytes) {}

    /// Returns the contents. Throws NewerFormat, DamagedTable and H5::Exception.
    FileContents read(const H5::H5File& file);

   private:
    void group(const H5::Group& at, const std::string& prefix, int depth);
    void dataset(const H5::DataSet& at, const std::string& path);
    void attributes(const H5::H5Object& at, const std::string& prefix);
    FileContents::Value value(const H5::Attribute& at, const std::string& path);
    FileContents::Value texts(const H5::Attribute& at, const std::string& path, bool is_list, std::size_t size);
    void take(std::size_t bytes, const std::string& path);

    const std::size_t bytes_;
    std::size_t taken_ = 0;
    FileContents contents_;
};

}  // namespace contactd

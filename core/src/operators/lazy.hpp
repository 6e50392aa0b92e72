// Holds a value that is created when it is first needed, by any thread.
#pragma once

#include <mutex>

namespace contactd {

template <class T>
class Lazy {
   public:
    template <class Make>
    const T& get(const Make& make) {
        std::call_once(made_, [&] { value_ = make(); });
        return value_;
    }

   private:
    std::once_flag made_;
    T value_;
};

}  // namespace contactd

// Makes the observer of the first process collective: all processes leave together when it cancels.
#pragma once

#include <mpi.h>

#include "contactd/observer.hpp"

namespace contactd::fem {

class CollectiveObserver {
   public:
    CollectiveObserver(MPI_Comm comm, Observer& observer) : comm_(comm), observer_(observer) {
        MPI_Comm_rank(comm, &rank_);
    }

    /// Reports on the first process. Collective; throws Cancelled on all processes when the observer of the first
    /// process cancels.
    void report(const Progress& progress) {
        int cancelled = 0;
        if (rank_ == 0) {
            observer_.on_progress(progress);
            cancelled = observer_.cancelled();
        }
        MPI_Bcast(&cancelled, 1, MPI_INT, 0, comm_);
        if (cancelled) throw Cancelled();
    }

   private:
    MPI_Comm comm_;
    Observer& observer_;
    int rank_ = 0;
};

}  // namespace contactd::fem

#include "wave_factor.hpp"

#include <cholmod.h>
#include <algorithm>
#include <new>

#include "contactd/error.hpp"

extern "C" {
void dtrsm_(const char* side, const char* uplo, const char* transposed, const char* diagonal, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dgemm_(const char* transposed_a, const char* transposed_b, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb, const double* beta,
            double* c, const int* ldc);
}

namespace contactd::fem {

struct WaveFactor::Library {
    cholmod_common common{};
    cholmod_sparse matrix{};
    cholmod_factor* factor = nullptr;

    Library() {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll = 1;
        common.print = 0;
        common.error_handler = nullptr;
    }
    ~Library() {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

namespace {

/// Describes a range of columns, [low, high).
struct Range {
    int low = 0, high = 0;
    int width() const { return high - low; }
    void include(const Range& other) {
        if (other.width() == 0) return;
        *this = width() == 0 ? other : Range{std::min(low, other.low), std::max(high, other.high)};
    }
};

/// Describes CHOLMOD's supernodal factor: supernode s contains the columns first(s)..first(s+1)-1 as a dense block by
/// columns, whose rows are first these columns themselves, and then those below.
class Supernodes {
   public:
    explicit Supernodes(const cholmod_factor& factor)
        : first_(static_cast<const int*>(factor.super)),
          rows_begin_(static_cast<const int*>(factor.pi)),
          block_begin_(static_cast<const int*>(factor.px)),
          rows_(static_cast<const int*>(factor.s)),
          values_(static_cast<const double*>(factor.x)),
          of_row_(factor.n) {
        count_ = static_cast<int>(factor.nsuper);
        for (int s = 0; s < count_; ++s)
            for (int row = first_[s]; row < first_[s + 1]; ++row) of_row_[row] = s;
    }
    int count() const { return count_; }
    int first(int s) const { return first_[s]; }
    int columns(int s) const { return first_[s + 1] - first_[s]; }
    int rows(int s) const { return rows_begin_[s + 1] - rows_begin_[s]; }
    const int* row_numbers(int s) const { return rows_ + rows_begin_[s]; }
    const double* block(int s) const { return values_ + block_begin_[s]; }
    int of_row(int row) const { return of_row_[row]; }

   private:
    const int *first_, *rows_begin_, *block_begin_, *rows_;
    const double* values_;
    std::vector<int> of_row_;
    int count_;
};

}  // namespace

/// Holds X = L^-1 P B. The rows of a supernode are stored row by row, for its range of columns only.
class WaveFactor::Forward {
   public:
    Forward(const Supernodes& nodes, const std::vector<int>& place, const SparseColumns& right) : nodes_(nodes) {
        find_ranges(place, right);
        for (std::size_t column = 0; column < right.columns.size(); ++column)
            for (const auto& [row, value] : right.columns[column])
                row_of(place[row])[static_cast<int>(column) - ranges_[nodes_.of_row(place[row])].low] += value;
        for (int s = 0; s < nodes_.count(); ++s)
            if (ranges_[s].width() > 0) eliminate(s);
    }

    const Range& range(int s) const { return ranges_[s]; }
    const double* block(int s) const { return values_.data() + begin_[s]; }

   private:
    void find_ranges(const std::vector<int>& place, const SparseColumns& right) {
        ranges_.resize(nodes_.count());
        for (std::size_t column = 0; column < right.columns.size(); ++column)
            for (const auto& entry : right.columns[column])
                ranges_[nodes_.of_row(place[entry.row])].include(
                    {static_cast<int>(column), static_cast<int>(column) + 1});
        begin_.resize(nodes_.count());
        std::size_t size = 0;
        for (int s = 0; s < nodes_.count(); ++s) {
            // The supernode of the first row below contains all the rows below.
            if (nodes_.rows(s) > nodes_.columns(s))
                ranges_[nodes_.of_row(nodes_.row_numbers(s)[nodes_.columns(s)])].include(ranges_[s]);
            begin_[s] = size;
            size += static_cast<std::size_t>(nodes_.columns(s)) * ranges_[s].width();
        }
        values_.assign(size, 0);
    }

    double* row_of(int row) {
        const int s = nodes_.of_row(row);
        return values_.data() + begin_[s] + static_cast<std::size_t>(row - nodes_.first(s)) * ranges_[s].width();
    }

    void eliminate(int s) {
        const int width = ranges_[s].width(), columns = nodes_.columns(s), rows = nodes_.rows(s),
                  below = rows - columns;
        const double one = 1, zero = 0;
        double* block = values_.data() + begin_[s];
        // Consecutive rows are the transposed block by columns.
        dtrsm_("R", "L", "T", "N", &width, &columns, &one, nodes_.block(s), &rows, block, &width);
        if (below == 0) return;
        change_.resize(static_cast<std::size_t>(below) * width);
        dgemm_("N", "T", &width, &below, &columns, &one, block, &width, nodes_.block(s) + columns, &rows, &zero,
               change_.data(), &width);
        for (int i = 0; i < below; ++i) {
            const int row = nodes_.row_numbers(s)[columns + i];
            double* target = row_of(row) + (ranges_[s].low - ranges_[nodes_.of_row(row)].low);
            const double* source = change_.data() + static_cast<std::size_t>(i) * width;
            for (int column = 0; column < width; ++column) target[column] -= source[column];
        }
    }

    const Supernodes& nodes_;
    std::vector<Range> ranges_;
    std::vector<std::size_t> begin_;
    std::vector<double> values_, change_;
};

WaveFactor::WaveFactor(const LowerPattern& pattern) : pattern_(pattern), library_(std::make_unique<Library>()) {
    cholmod_sparse& matrix = library_->matrix;
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(pattern.size());
    matrix.nzmax = pattern.row.size();
    matrix.p = const_cast<int*>(pattern.begin.data());
    matrix.i = const_cast<int*>(pattern.row.data());
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_PATTERN;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    library_->factor = cholmod_analyze(&matrix, &library_->common);
    if (!library_->factor) throw std::bad_alloc();
}

WaveFactor::~WaveFactor() = default;

double WaveFactor::operations() const {
    return library_->common.fl;
}

double WaveFactor::entries() const {
    return library_->common.lnz;
}

void WaveFactor::factorise(std::vector<double> values) {
    cholmod_sparse matrix = library_->matrix;
    matrix.x = values.data();
    matrix.xtype = CHOLMOD_REAL;
    cholmod_factorize(&matrix, library_->factor, &library_->common);
    if (library_->common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (library_->factor->minor < library_->factor->n || library_->common.status < CHOLMOD_OK)
        throw NotConverged(
            "The stiffness matrix of the section could not be factorised: it is not positive definite to rounding.");
}

std::vector<double> WaveFactor::response(const SparseColumns& observations, const SparseColumns& loads) const {
    const Supernodes nodes(*library_->factor);
    const int* original = static_cast<const int*>(library_->factor->Perm);
    std::vector<int> place(library_->factor->n);
    for (std::size_t i = 0; i < place.size(); ++i) place[original[i]] = static_cast<int>(i);
    const Forward left(nodes, place, observations), right(nodes, place, loads);
    const auto count = static_cast<int>(observations.columns.size());
    std::vector<double> result(observations.columns.size() * loads.columns.size());
    for (int s = 0; s < nodes.count(); ++s) {
        const Range &rows = left.range(s), &columns = right.range(s);
        if (rows.width() == 0 || columns.width() == 0) continue;
        const int m = rows.width(), n = columns.width(), k = nodes.columns(s);
        const double one = 1;
        dgemm_("N", "T", &m, &n, &k, &one, left.block(s), &m, right.block(s), &n, &one,
               result.data() + rows.low + static_cast<std::size_t>(columns.low) * count, &count);
    }
    return result;
}

}  // namespace contactd::fem

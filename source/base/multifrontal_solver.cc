#include <caudal/base/multifrontal_solver.h>

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** Columns that are eliminated at once: few enough for the cache, many enough for BLAS. */
    constexpr int panel_width = 32;
    /** The same for the triangular solutions in them, which BLAS is slow at. */
    constexpr int small_width = 8;

    /** A pivot is poor where the entries below it are larger by this factor (MUMPS' 1e-6). */
    constexpr double largest_growth = 1e6;
    /**
     * Where more pivots than this part are poor, the others are not good either. Schools of
     * bodies with nodes 0.36 cells apart: 9 %, and 13 to 40 iterations; else none, and 1 to 4.
     */
    constexpr double largest_part_poor = 0.01;

    /** A dense matrix stored column by column, or a part of it. */
    struct Block
    {
      double *data;
      int     n_rows, n_columns, stride;

      double *column(const int j) const
      {
        return data + static_cast<std::size_t>(j) * stride;
      }

      Block part(const int row, const int column_index, const int rows, const int columns) const
      {
        return {column(column_index) + row, rows, columns, stride};
      }
    };

    /** c := beta c + alpha a b */
    void multiply(const double alpha, const Block &a, const Block &b, const double beta,
                  const Block &c)
    {
      if (c.n_rows == 0 || c.n_columns == 0)
        return;
      const types::blas_int m = c.n_rows, n = c.n_columns, k = a.n_columns;
      const types::blas_int stride_a = a.stride, stride_b = b.stride, stride_c = c.stride;
      gemm("N", "N", &m, &n, &k, &alpha, a.data, &stride_a, b.data, &stride_b, &beta, c.data,
           &stride_c);
    }

    /** y += alpha a x */
    void multiply(const double alpha, const Block &a, const double *x, double *y)
    {
      if (a.n_rows == 0 || a.n_columns == 0)
        return;
      const types::blas_int m = a.n_rows, n = a.n_columns, stride = a.stride, one = 1;
      const double          beta = 1;
      gemv("N", &m, &n, &alpha, a.data, &stride, x, &one, &beta, y, &one);
    }

    /**
     * The factors of a front: A = [pivots, right; below, update] becomes L U with
     * pivots = L_11 U_11 (rows exchanged), right = U_12, below = L_21.
     */
    struct FrontFactors
    {
      FrontFactors(const EliminationTree::Front &front, double *data, int *exchanges)
          : pivots{data, static_cast<int>(front.n_pivots), static_cast<int>(front.n_pivots),
                   static_cast<int>(front.n_pivots)}
          , right{pivots.column(front.n_pivots), pivots.n_rows, static_cast<int>(front.n_rest),
                  pivots.stride}
          , below{right.column(front.n_rest), static_cast<int>(front.n_rest), pivots.n_columns,
                  static_cast<int>(front.n_rest)}
          , exchanges(exchanges)
      {}

      static std::size_t count(const EliminationTree::Front &front)
      {
        return static_cast<std::size_t>(front.n_pivots) * (front.n_pivots + 2 * front.n_rest);
      }

      Block pivots, right, below;
      int  *exchanges;
    };

    /** LU of a panel without any BLAS, rows exchanged; returns false if a pivot is zero. */
    bool factorize_panel(const Block &panel, int *exchanges)
    {
      for (int c = 0; c < panel.n_columns; ++c)
      {
        double    *pivot_column = panel.column(c);
        const auto largest      = std::max_element(
                 pivot_column + c, pivot_column + panel.n_rows,
                 [](const double a, const double b) { return std::abs(a) < std::abs(b); });
        if (!(std::abs(*largest) > 0.))
          return false;
        exchanges[c] = largest - pivot_column;
        if (exchanges[c] != c)
          for (int j = 0; j < panel.n_columns; ++j)
            std::swap(panel.column(j)[c], panel.column(j)[exchanges[c]]);
        const double inverse = 1 / pivot_column[c];
        for (int i = c + 1; i < panel.n_rows; ++i)
          pivot_column[i] *= inverse;
        for (int j = c + 1; j < panel.n_columns; ++j)
        {
          double      *column = panel.column(j);
          const double factor = column[c];
          for (int i = c + 1; i < panel.n_rows; ++i)
            column[i] -= pivot_column[i] * factor;
        }
      }
      return true;
    }

    /** The inverse of the unit lower triangle of @p lower, whose entries are at most one. */
    void invert_unit_lower_triangle(const Block &lower, const Block &inverse)
    {
      const int n = lower.n_columns;
      for (int c = 0; c < n; ++c)
      {
        double *column = inverse.column(c);
        std::fill(column, column + n, 0.);
        column[c] = 1;
        for (int j = c; j < n; ++j)
        {
          const double *l      = lower.column(j);
          const double  factor = column[j];
          for (int i = j + 1; i < n; ++i)
            column[i] -= factor * l[i];
        }
      }
    }

    /**
     * x := x U^-1, U the upper triangle of @p upper: by substitution, since the augmented matrix
     * makes its condition number 1e9, and an explicit inverse loses half of the digits.
     */
    void solve_from_right(const Block &upper, const Block &x)
    {
      for (int begin = 0; begin < upper.n_columns; begin += small_width)
      {
        const int end = std::min(begin + small_width, upper.n_columns);
        for (int j = begin; j < end; ++j)
        {
          double       *column = x.column(j);
          const double *u      = upper.column(j);
          for (int i = begin; i < j; ++i)
          {
            const double *other  = x.column(i);
            const double  factor = u[i];
            for (int row = 0; row < x.n_rows; ++row)
              column[row] -= factor * other[row];
          }
          const double inverse = 1 / u[j];
          for (int row = 0; row < x.n_rows; ++row)
            column[row] *= inverse;
        }
        const int n_left = upper.n_columns - end;
        multiply(-1, x.part(0, begin, x.n_rows, end - begin),
                 upper.part(begin, end, end - begin, n_left), 1, x.part(0, end, x.n_rows, n_left));
      }
    }

    void exchange_rows(const Block &block, const int first, const int second)
    {
      for (int j = 0; j < block.n_columns; ++j)
        std::swap(block.column(j)[first], block.column(j)[second]);
    }

    /** right := L^-1 right for a panel's rows, L its unit lower triangle. */
    void solve_from_left(const Block &inverse, const Block &right, std::vector<double> &buffer)
    {
      buffer.resize(static_cast<std::size_t>(right.n_rows) * right.n_columns);
      const Block copy{buffer.data(), right.n_rows, right.n_columns, right.n_rows};
      for (int j = 0; j < right.n_columns; ++j)
        std::copy_n(right.column(j), right.n_rows, copy.column(j));
      multiply(1, inverse, copy, 0, right);
    }

    /** Eliminates the pivots of a front, panel by panel; returns false if one is zero. */
    bool eliminate_pivots(const FrontFactors &front, const Block &update,
                          std::vector<double> &buffer)
    {
      const int n = front.pivots.n_columns;
      double    inverse_data[panel_width * panel_width];
      for (int begin = 0; begin < n; begin += panel_width)
      {
        const int   width = std::min(panel_width, n - begin), end = begin + width;
        const Block panel = front.pivots.part(begin, begin, n - begin, width);
        if (!factorize_panel(panel, front.exchanges + begin))
          return false;
        for (int c = begin; c < end; ++c)
        {
          front.exchanges[c] += begin;
          if (front.exchanges[c] == c)
            continue;
          exchange_rows(front.pivots.part(0, 0, n, begin), c, front.exchanges[c]);
          exchange_rows(front.pivots.part(0, end, n, n - end), c, front.exchanges[c]);
          exchange_rows(front.right, c, front.exchanges[c]);
        }
        const Block diagonal = panel.part(0, 0, width, width);
        const Block lower    = panel.part(width, 0, n - end, width);
        const Block inverse{inverse_data, width, width, width};
        invert_unit_lower_triangle(diagonal, inverse);

        const Block upper = front.pivots.part(begin, end, width, n - end);
        const Block right = front.right.part(begin, 0, width, front.right.n_columns);
        const Block below = front.below.part(0, begin, front.below.n_rows, width);
        solve_from_left(inverse, upper, buffer);
        solve_from_left(inverse, right, buffer);
        solve_from_right(diagonal, below);
        multiply(-1, lower, upper, 1, front.pivots.part(end, end, n - end, n - end));
        multiply(-1, lower, right, 1, front.right.part(end, 0, n - end, right.n_columns));
        multiply(-1, below, upper, 1, front.below.part(0, end, below.n_rows, n - end));
      }
      multiply(-1, front.below, front.right, 1, update);
      return true;
    }

    unsigned int count_poor_pivots(const FrontFactors &front)
    {
      unsigned int n_poor = 0;
      for (int j = 0; j < front.below.n_columns; ++j)
      {
        const double *column  = front.below.column(j);
        double        largest = 0;
        for (int i = 0; i < front.below.n_rows; ++i)
          largest = std::max(largest, std::abs(column[i]));
        if (!(largest < largest_growth))
          ++n_poor;
      }
      return n_poor;
    }

    /**
     * Adds what a front left for its rest to its parent, whose blocks are @p front and
     * @p update. @p places: where the rest is in the parent, ascending.
     */
    void add_update(const std::vector<double> &child, const std::vector<int> &places,
                    const FrontFactors &front, const Block &update)
    {
      const int n = places.size(), n_pivots = front.pivots.n_columns;
      const int n_to_pivots =
          std::lower_bound(places.begin(), places.end(), n_pivots) - places.begin();
      for (int j = 0; j < n; ++j)
      {
        const double *source = child.data() + static_cast<std::size_t>(j) * n;
        const int     column = places[j];
        double       *top =
            column < n_pivots ? front.pivots.column(column) : front.right.column(column - n_pivots);
        double *bottom =
            (column < n_pivots ? front.below.column(column) : update.column(column - n_pivots));
        for (int i = 0; i < n_to_pivots; ++i)
          top[places[i]] += source[i];
        for (int i = n_to_pivots; i < n; ++i)
          bottom[places[i] - n_pivots] += source[i];
      }
    }

    struct Entry
    {
      int    row, column;
      double value;
    };

    /** The scaled entries, those of a front together: that which eliminates the first unknown. */
    struct EntriesOfFronts
    {
      EntriesOfFronts(const EliminationTree &tree, const std::vector<double> &scales,
                      const Triplets &entries)
          : begins(tree.fronts.size() + 2)
          , sorted(entries.values.size())
      {
        std::vector<int> front(sorted.size());
        for (std::size_t k = 0; k < sorted.size(); ++k)
        {
          const int row = entries.rows[k], column = entries.columns[k];
          const int first = tree.place[row] < tree.place[column] ? row : column;
          // Behind all fronts those between kept unknowns.
          front[k] = tree.front_of[first] < 0 ? tree.fronts.size() : tree.front_of[first];
          ++begins[front[k] + 1];
        }
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        std::vector<int> next(begins);
        for (std::size_t k = 0; k < sorted.size(); ++k)
        {
          const int row = entries.rows[k], column = entries.columns[k];
          sorted[next[front[k]]++] = {row, column,
                                      entries.values[k] * scales[row] * scales[column]};
        }
      }

      std::vector<int>   begins;
      std::vector<Entry> sorted;
    };

    void add_entries(const Entry *begin, const Entry *end, const std::vector<int> &local,
                     const FrontFactors &front)
    {
      const int n_pivots = front.pivots.n_columns;
      for (const Entry *entry = begin; entry != end; ++entry)
      {
        const int row = local[entry->row], column = local[entry->column];
        if (column >= n_pivots)
          front.right.column(column - n_pivots)[row] += entry->value;
        else if (row >= n_pivots)
          front.below.column(column)[row - n_pivots] += entry->value;
        else
          front.pivots.column(column)[row] += entry->value;
      }
    }

    void gather(const std::vector<double> &vector, const int *unknowns, const unsigned int n,
                std::vector<double> &result)
    {
      result.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        result[i] = vector[unknowns[i]];
    }
  } // namespace

  void MultifrontalSolver::compute_scales(const Triplets &entries, const unsigned int n)
  {
    scales.assign(n, 0.);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
    {
      const double value         = std::abs(entries.values[k]);
      scales[entries.rows[k]]    = std::max(scales[entries.rows[k]], value);
      scales[entries.columns[k]] = std::max(scales[entries.columns[k]], value);
    }
    for (unsigned int i = 0; i < n; ++i)
      scales[i] = i < n_eliminated && scales[i] > 0. ? 1 / std::sqrt(scales[i]) : 1.;
  }

  void MultifrontalSolver::lay_out_factors()
  {
    factor_begins.assign(1, 0);
    exchange_begins.assign(1, 0);
    for (const auto &front : tree.fronts)
    {
      factor_begins.push_back(factor_begins.back() + FrontFactors::count(front));
      exchange_begins.push_back(exchange_begins.back() + front.n_pivots);
    }
    factors.assign(factor_begins.back(), 0.);
    exchanges.resize(exchange_begins.back());
  }

  void MultifrontalSolver::add_to_schur_complement(const EliminationTree::Front &front,
                                                   const std::vector<double>    &update)
  {
    const int  *rest   = tree.unknowns.data() + front.begin + front.n_pivots;
    std::size_t n_kept = scales.size() - n_eliminated;
    for (unsigned int j = 0; j < front.n_rest; ++j)
      for (unsigned int i = 0; i < front.n_rest; ++i)
        schur_complement[(rest[i] - n_eliminated) * n_kept + rest[j] - n_eliminated] +=
            update[static_cast<std::size_t>(j) * front.n_rest + i];
  }

  bool MultifrontalSolver::factorize(const std::vector<int> &group_begins, const Triplets &entries,
                                     const unsigned int n_kept)
  {
    const unsigned int n = group_begins.back();
    n_eliminated         = n - n_kept;
    tree.build(group_begins, entries, n_kept);
    compute_scales(entries, n);
    lay_out_factors();
    schur_complement.assign(static_cast<std::size_t>(n_kept) * n_kept, 0.);
    return eliminate(entries);
  }

  bool MultifrontalSolver::eliminate(const Triplets &entries)
  {
    const EntriesOfFronts            entries_of_fronts(tree, scales, entries);
    std::vector<std::vector<double>> updates(tree.fronts.size());
    std::vector<std::vector<int>>    children(tree.fronts.size());
    std::vector<int>                 local(scales.size()), places;
    std::vector<double>              buffer;
    unsigned int                     n_poor_pivots = 0;
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
    {
      const auto        &front = tree.fronts[f];
      const FrontFactors factor(front, &factors[factor_begins[f]], &exchanges[exchange_begins[f]]);
      const int          n_pivots = front.n_pivots, n_rest = front.n_rest;
      updates[f].resize(static_cast<std::size_t>(n_rest) * n_rest);
      const Block update{updates[f].data(), n_rest, n_rest, n_rest};
      for (int i = 0; i < n_pivots + n_rest; ++i)
        local[tree.unknowns[front.begin + i]] = i;

      const Entry *sorted = entries_of_fronts.sorted.data();
      add_entries(sorted + entries_of_fronts.begins[f], sorted + entries_of_fronts.begins[f + 1],
                  local, factor);
      for (const int child : children[f])
      {
        const auto &other = tree.fronts[child];
        places.resize(other.n_rest);
        for (unsigned int i = 0; i < other.n_rest; ++i)
          places[i] = local[tree.unknowns[other.begin + other.n_pivots + i]];
        add_update(updates[child], places, factor, update);
        std::vector<double>().swap(updates[child]);
      }
      if (!eliminate_pivots(factor, update, buffer))
        return false;
      n_poor_pivots += count_poor_pivots(factor);
      if (front.parent >= 0)
        children[front.parent].push_back(f);
      else if (n_rest > 0)
        add_to_schur_complement(front, updates[f]);
    }
    const std::size_t n_kept = scales.size() - n_eliminated;
    for (std::size_t e = entries_of_fronts.begins[tree.fronts.size()];
         e < entries_of_fronts.sorted.size(); ++e)
    {
      const auto &[row, column, value] = entries_of_fronts.sorted[e];
      schur_complement[(row - n_eliminated) * n_kept + column - n_eliminated] += value;
    }
    return n_poor_pivots <= largest_part_poor * n_eliminated;
  }

  double MultifrontalSolver::get_factor_operations() const
  {
    double sum = 0;
    for (const auto &[begin, n_pivots, n_rest, parent] : tree.fronts)
    {
      const double k = n_pivots, r = n_rest;
      sum += k * (2. / 3. * k * k + 2 * k * r + 2 * r * r);
    }
    return sum;
  }

  void MultifrontalSolver::condense(std::vector<double> &vector)
  {
    AssertDimension(vector.size(), scales.size());
    for (unsigned int i = 0; i < n_eliminated; ++i)
      vector[i] *= scales[i];
    std::vector<double> pivots, rest;
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
    {
      const auto        &front    = tree.fronts[f];
      const int         *unknowns = tree.unknowns.data() + front.begin;
      const FrontFactors factor(front, &factors[factor_begins[f]], &exchanges[exchange_begins[f]]);
      gather(vector, unknowns, front.n_pivots, pivots);
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        std::swap(pivots[i], pivots[factor.exchanges[i]]);
      for (unsigned int j = 0; j < front.n_pivots; ++j)
        for (unsigned int i = j + 1; i < front.n_pivots; ++i)
          pivots[i] -= factor.pivots.column(j)[i] * pivots[j];
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        vector[unknowns[i]] = pivots[i];
      rest.assign(front.n_rest, 0.);
      multiply(1, factor.below, pivots.data(), rest.data());
      for (unsigned int i = 0; i < front.n_rest; ++i)
        vector[unknowns[front.n_pivots + i]] -= rest[i];
    }
  }

  void MultifrontalSolver::expand(std::vector<double> &vector)
  {
    AssertDimension(vector.size(), scales.size());
    std::vector<double> pivots, rest;
    for (std::size_t f = tree.fronts.size(); f-- > 0;)
    {
      const auto        &front    = tree.fronts[f];
      const int         *unknowns = tree.unknowns.data() + front.begin;
      const FrontFactors factor(front, &factors[factor_begins[f]], &exchanges[exchange_begins[f]]);
      gather(vector, unknowns, front.n_pivots, pivots);
      gather(vector, unknowns + front.n_pivots, front.n_rest, rest);
      multiply(-1, factor.right, rest.data(), pivots.data());
      for (unsigned int j = front.n_pivots; j-- > 0;)
      {
        pivots[j] /= factor.pivots.column(j)[j];
        for (unsigned int i = 0; i < j; ++i)
          pivots[i] -= factor.pivots.column(j)[i] * pivots[j];
      }
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        vector[unknowns[i]] = pivots[i];
    }
    for (unsigned int i = 0; i < n_eliminated; ++i)
      vector[i] *= scales[i];
  }
} // namespace caudal

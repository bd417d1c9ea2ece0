#include <caudal/linear/elimination_tree.h>

#include <deal.II/base/exceptions.h>

#include <cholmod.h>

#include <algorithm>
#include <memory>
#include <numeric>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** CHOLMOD's settings and its work space. */
    class Cholmod
    {
    public:
      Cholmod()
      {
        cholmod_start(&data);
        data.supernodal         = CHOLMOD_SUPERNODAL;
        data.nmethods           = 1;
        data.method[0].ordering = CHOLMOD_GIVEN;
        data.postorder          = 1;
        data.print              = 0;
        // Fronts are joined where that adds few zeros. With CHOLMOD's own limits, which are meant
        // for single unknowns rather than groups, there are a tenth more operations.
        data.nrelax[0] = 2;
        data.nrelax[1] = 8;
        data.nrelax[2] = 24;
      }

      ~Cholmod()
      {
        cholmod_finish(&data);
      }

      Cholmod(const Cholmod &)            = delete;
      Cholmod &operator=(const Cholmod &) = delete;

      void check(const bool succeeded) const
      {
        AssertThrow(succeeded && data.status >= CHOLMOD_OK,
                    ExcMessage("The direct solver's analysis (CHOLMOD) failed with status " +
                               std::to_string(data.status) + " (-2: out of memory)."));
      }

      cholmod_common data;
    };

    /** What couples groups: the elements' groups without repetition, and pairs of groups. */
    struct Cliques
    {
      Cliques(const std::vector<int> &group_of, const int n_groups, const MatrixParts &matrix)
          : begins(1, 0)
      {
        std::vector<std::size_t> last_clique(n_groups, -1);
        const auto               add = [&](const int unknown) {
          const int group = group_of[unknown];
          if (last_clique[group] != begins.size())
          {
            last_clique[group] = begins.size();
            groups.push_back(group);
          }
        };
        for (const ElementMatrix &element : matrix.elements)
        {
          std::for_each(element.unknowns, element.unknowns + element.n, add);
          begins.push_back(groups.size());
        }
        for (std::size_t k = 0; k < matrix.entries.values.size(); ++k)
        {
          const int row    = group_of[matrix.entries.rows[k]];
          const int column = group_of[matrix.entries.columns[k]];
          if (row != column)
          {
            groups.push_back(row);
            groups.push_back(column);
            begins.push_back(groups.size());
          }
        }
      }

      std::size_t count() const
      {
        return begins.size() - 1;
      }

      std::vector<int> begins, groups;
    };

    /** Upper triangle of the groups' pattern with the diagonal, column by column. */
    struct Pattern
    {
      Pattern(const int n_groups, const Cliques &cliques)
          : begins(n_groups + 1)
      {
        // The cliques of each group.
        std::vector<int> ends(n_groups + 1);
        for (const int group : cliques.groups)
          ++ends[group + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        const std::vector<int> list_begins(ends);
        std::vector<int>       lists(cliques.groups.size());
        for (std::size_t c = 0; c < cliques.count(); ++c)
          for (int k = cliques.begins[c]; k < cliques.begins[c + 1]; ++k)
            lists[ends[cliques.groups[k]]++] = c;

        std::vector<int> last_column(n_groups, -1);
        for (int column = 0; column < n_groups; ++column)
        {
          begins[column] = rows.size();
          rows.push_back(column);
          for (int l = list_begins[column]; l < list_begins[column + 1]; ++l)
            for (int k = cliques.begins[lists[l]]; k < cliques.begins[lists[l] + 1]; ++k)
            {
              const int row = cliques.groups[k];
              if (row < column && last_column[row] != column)
              {
                last_column[row] = column;
                rows.push_back(row);
              }
            }
        }
        begins[n_groups] = rows.size();
      }

      cholmod_sparse get_view()
      {
        cholmod_sparse view{};
        view.nrow = view.ncol = begins.size() - 1;
        view.nzmax            = rows.size();
        view.p                = begins.data();
        view.i                = rows.data();
        view.stype            = 1;
        view.itype            = CHOLMOD_INT;
        view.xtype            = CHOLMOD_PATTERN;
        view.dtype            = CHOLMOD_DOUBLE;
        view.packed           = 1;
        return view;
      }

      std::vector<int> begins, rows;
    };

    std::vector<int> find_order(Cholmod &cholmod, cholmod_sparse &pattern, const int n_eliminated)
    {
      std::vector<int> order(pattern.ncol), constraints(pattern.ncol);
      std::fill(constraints.begin() + n_eliminated, constraints.end(), 1);
      cholmod.check(
          cholmod_camd(&pattern, nullptr, 0, constraints.data(), order.data(), &cholmod.data) != 0);
      return order;
    }
  } // namespace

  void EliminationTree::build(const std::vector<int> &group_begins, const MatrixParts &matrix,
                              const unsigned int n_kept)
  {
    const int        n_groups = group_begins.size() - 1, n = group_begins.back();
    std::vector<int> group_of(n);
    for (int group = 0; group < n_groups; ++group)
      std::fill(group_of.begin() + group_begins[group], group_of.begin() + group_begins[group + 1],
                group);
    const int first_kept_group = n_kept > 0 ? group_of[n - n_kept] : n_groups;

    Cholmod          cholmod;
    Pattern          pattern(n_groups, Cliques(group_of, n_groups, matrix));
    cholmod_sparse   view  = pattern.get_view();
    std::vector<int> order = find_order(cholmod, view, first_kept_group);

    const auto free_factor = [&](cholmod_factor *factor) {
      cholmod_free_factor(&factor, &cholmod.data);
    };
    const std::unique_ptr<cholmod_factor, decltype(free_factor)> factor(
        cholmod_analyze_p(&view, order.data(), nullptr, 0, &cholmod.data), free_factor);
    cholmod.check(factor != nullptr);
    const auto *groups = static_cast<const int *>(factor->Perm);
    const auto *first  = static_cast<const int *>(factor->super); // places of the first pivots
    const auto *begin  = static_cast<const int *>(factor->pi);    // of a front in `rows`
    const auto *rows   = static_cast<const int *>(factor->s);     // places, ascending

    fronts.clear();
    unknowns.clear();
    front_of.assign(n, -1);
    place.assign(n, n);
    for (std::size_t s = 0; s < factor->nsuper; ++s)
    {
      Front front{unknowns.size(), 0, 0, -1};
      for (int k = begin[s]; k < begin[s + 1]; ++k)
      {
        const int  group    = groups[rows[k]];
        const bool is_pivot = rows[k] < first[s + 1] && group < first_kept_group;
        for (int unknown = group_begins[group]; unknown < group_begins[group + 1]; ++unknown)
        {
          unknowns.push_back(unknown);
          if (is_pivot)
          {
            place[unknown]    = rows[k];
            front_of[unknown] = fronts.size();
          }
          ++(is_pivot ? front.n_pivots : front.n_rest);
        }
      }
      if (front.n_pivots > 0)
        fronts.push_back(front);
      else
        unknowns.resize(front.begin);
    }
    for (Front &front : fronts)
      if (front.n_rest > 0)
        front.parent = front_of[unknowns[front.begin + front.n_pivots]];
  }
} // namespace caudal

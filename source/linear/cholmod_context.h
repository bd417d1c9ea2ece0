// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_linear_cholmod_context_h
#define caudal_source_linear_cholmod_context_h

#include <deal.II/base/exceptions.h>

#include <cholmod.h>

#include <memory>
#include <string>

namespace caudal
{
  /** CHOLMOD's settings and its work space: supernodal factors by one ordering. */
  class Cholmod
  {
  public:
    explicit Cholmod(const int ordering)
    {
      cholmod_start(&data);
      data.supernodal         = CHOLMOD_SUPERNODAL;
      data.nmethods           = 1;
      data.method[0].ordering = ordering;
      data.postorder          = 1;
      data.print              = 0;
    }

    ~Cholmod()
    {
      cholmod_finish(&data);
    }

    Cholmod(const Cholmod &)            = delete;
    Cholmod &operator=(const Cholmod &) = delete;

    operator cholmod_common *()
    {
      return &data;
    }

    struct Free
    {
      cholmod_common *data;

      void operator()(cholmod_sparse *matrix) const
      {
        cholmod_free_sparse(&matrix, data);
      }
      void operator()(cholmod_dense *vector) const
      {
        cholmod_free_dense(&vector, data);
      }
      void operator()(cholmod_factor *factor) const
      {
        cholmod_free_factor(&factor, data);
      }
    };
    using Matrix = std::unique_ptr<cholmod_sparse, Free>;
    using Dense  = std::unique_ptr<cholmod_dense, Free>;
    using Factor = std::unique_ptr<cholmod_factor, Free>;

    template <typename T>
    std::unique_ptr<T, Free> own(T *object)
    {
      check(object != nullptr);
      return std::unique_ptr<T, Free>(object, Free{&data});
    }

    void check(const bool succeeded) const
    {
      AssertThrow(succeeded && data.status >= CHOLMOD_OK,
                  dealii::ExcMessage("The direct solver's analysis (CHOLMOD) failed with status " +
                                     std::to_string(data.status) + " (-2: out of memory)."));
    }

    cholmod_common data;
  };
} // namespace caudal

#endif

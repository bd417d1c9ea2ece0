#include <caudal/base/factory.h>
#include <caudal/coupling/kernel.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    class FourPoint : public DeltaKernel
    {
    public:
      double value(const double r) const override
      {
        const double a = std::abs(r);
        if (a >= 2.)
          return 0.;
        if (a <= 1.)
          return 0.125 * (3. - 2. * a + std::sqrt(1. + 4. * a - 4. * a * a));
        return 0.125 * (5. - 2. * a - std::sqrt(-7. + 12. * a - 4. * a * a));
      }

      double radius() const override
      {
        return 2.;
      }

      unsigned int n_quadrature_points() const override
      {
        return 20; // the roots have branch points 0.2 beyond the knots
      }
    };

    class Cosine : public DeltaKernel
    {
    public:
      double value(const double r) const override
      {
        return std::abs(r) < 2. ? 0.25 * (1. + std::cos(0.5 * numbers::PI * r)) : 0.;
      }

      double radius() const override
      {
        return 2.;
      }

      unsigned int n_quadrature_points() const override
      {
        return 8;
      }
    };

    class ThreePoint : public DeltaKernel
    {
    public:
      double value(const double r) const override
      {
        const double a = std::abs(r);
        if (a >= 1.5)
          return 0.;
        if (a <= 0.5)
          return (1. + std::sqrt(1. - 3. * a * a)) / 3.;
        return (5. - 3. * a - std::sqrt(1. - 3. * (1. - a) * (1. - a))) / 6.;
      }

      double radius() const override
      {
        return 1.5;
      }

      unsigned int n_quadrature_points() const override
      {
        return 20; // as above, 0.08 beyond
      }
    };

    /** The cardinal B-spline of order k: the k-fold convolution of the unit box. */
    class BSpline : public DeltaKernel
    {
    public:
      explicit BSpline(const unsigned int order)
          : order(order)
      {}

      /**
       * sum_j (-1)^j binomial(k,j) (y-j)_+^(k-1)/(k-1)!, with the distance y from
       * the nearer end of the support: few terms and no cancellation.
       */
      double value(const double r) const override
      {
        const double y           = radius() - std::abs(r);
        double       sum         = 0.;
        double       coefficient = 1.;
        for (unsigned int j = 0; j < y; ++j)
        {
          sum += coefficient * power(y - j);
          coefficient *= -static_cast<double>(order - j) / (j + 1);
        }
        return sum;
      }

      double radius() const override
      {
        return 0.5 * order;
      }

      unsigned int n_quadrature_points() const override
      {
        return (order + 3) / 2; // for the degree order - 1, times quadratics
      }

    private:
      /** x^(k-1)/(k-1)! */
      double power(const double x) const
      {
        double product = 1.;
        for (unsigned int i = 1; i < order; ++i)
          product *= x / i;
        return product;
      }

      const unsigned int order;
    };

    template <class Kernel, class... Args>
    std::unique_ptr<KernelPair> make_isotropic(const Args... args)
    {
      auto pair    = std::make_unique<KernelPair>();
      pair->along  = std::make_unique<Kernel>(args...);
      pair->across = std::make_unique<Kernel>(args...);
      return pair;
    }

    std::unique_ptr<KernelPair> make_composite(const unsigned int order_along)
    {
      auto pair       = std::make_unique<KernelPair>();
      pair->along     = std::make_unique<BSpline>(order_along);
      pair->across    = std::make_unique<BSpline>(order_along - 1);
      pair->isotropic = false;
      return pair;
    }

    std::unique_ptr<KernelPair> make_dirac()
    {
      auto pair      = std::make_unique<KernelPair>();
      pair->is_dirac = true;
      return pair;
    }

    const Factory<KernelPair> &get_factory()
    {
      static const Factory<KernelPair> factory(
          "kernel", {{"four-point", [] { return make_isotropic<FourPoint>(); }},
                     {"cosine", [] { return make_isotropic<Cosine>(); }},
                     {"three-point", [] { return make_isotropic<ThreePoint>(); }},
                     {"hat", [] { return make_isotropic<BSpline>(2u); }},
                     {"B-spline 3", [] { return make_isotropic<BSpline>(3u); }},
                     {"B-spline 4", [] { return make_isotropic<BSpline>(4u); }},
                     {"B-spline 5", [] { return make_isotropic<BSpline>(5u); }},
                     {"B-spline 6", [] { return make_isotropic<BSpline>(6u); }},
                     {"composite B-spline 32", [] { return make_composite(3); }},
                     {"composite B-spline 43", [] { return make_composite(4); }},
                     {"composite B-spline 54", [] { return make_composite(5); }},
                     {"dirac", [] { return make_dirac(); }}});
      return factory;
    }
  } // namespace

  double KernelPair::radius() const
  {
    return is_dirac ? 0. : std::max(along->radius(), across->radius());
  }

  KernelPair create_kernel(const std::string &name)
  {
    return std::move(*get_factory().create(name));
  }

  std::string get_kernel_names()
  {
    return get_factory().get_names();
  }
} // namespace caudal

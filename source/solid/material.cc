#include <caudal/base/factory.h>
#include <caudal/solid/stress.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** Calls @p entry(i, J, k, L) for each entry of a tangent. */
    template <int dim, typename Entry>
    Tensor<4, dim> make_tangent(const Entry &entry)
    {
      Tensor<4, dim> tangent;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int L = 0; L < dim; ++L)
              tangent[i][J][k][L] = entry(i, J, k, L);
      return tangent;
    }

    template <int dim>
    double positive_determinant(const Tensor<2, dim> &F)
    {
      const double J = determinant(F);
      AssertThrow(J > 0., ExcInvertedElement(J));
      return J;
    }

    /** F^-T, the derivative of ln J. */
    template <int dim>
    Tensor<2, dim> inverse_transpose(const Tensor<2, dim> &F)
    {
      return transpose(invert(F));
    }

    template <int dim>
    class NoStress : public StressModel<dim>
    {
    public:
      explicit NoStress(const MaterialParameters &) {}

      double strain_energy(const Tensor<2, dim> &) const override
      {
        return 0.;
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &) const override
      {
        return Tensor<2, dim>();
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &) const override
      {
        return Tensor<4, dim>();
      }
    };

    template <int dim>
    class NeoHookean : public StressModel<dim>
    {
    public:
      explicit NeoHookean(const MaterialParameters &parameters)
          : mu(parameters.get_shear_modulus())
      {}

      double strain_energy(const Tensor<2, dim> &F) const override
      {
        return mu * (0.5 * (F.norm_square() - dim) - std::log(positive_determinant(F)));
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const override
      {
        return mu * (F - inverse_transpose(F));
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F) const override
      {
        const Tensor<2, dim> G = inverse_transpose(F);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return mu * ((i == k && J == L ? 1. : 0.) + G[k][J] * G[i][L]);
        });
      }

    private:
      const double mu;
    };

    template <int dim>
    class ModifiedNeoHookean : public StressModel<dim>
    {
    public:
      explicit ModifiedNeoHookean(const MaterialParameters &parameters)
          : mu(parameters.get_shear_modulus())
      {}

      double strain_energy(const Tensor<2, dim> &F) const override
      {
        return 0.5 * (scaled_modulus(F) * F.norm_square() - mu * dim);
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const override
      {
        return scaled_modulus(F) * (F - F.norm_square() / dim * inverse_transpose(F));
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F) const override
      {
        const Tensor<2, dim> G         = inverse_transpose(F);
        const double         a         = scaled_modulus(F);
        const double         mean      = F.norm_square() / dim;
        const Tensor<2, dim> deviation = F - mean * G;
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return a * ((i == k && J == L ? 1. : 0.) + mean * G[k][J] * G[i][L] -
                      2. / dim * (G[i][J] * F[k][L] + deviation[i][J] * G[k][L]));
        });
      }

    private:
      /** mu J^(-2/dim) */
      double scaled_modulus(const Tensor<2, dim> &F) const
      {
        return mu * std::pow(positive_determinant(F), -2. / dim);
      }

      const double mu;
    };

    template <int dim>
    class StVenantKirchhoff : public StressModel<dim>
    {
    public:
      explicit StVenantKirchhoff(const MaterialParameters &parameters)
          : mu(parameters.get_shear_modulus())
          , lambda(parameters.get_lame_modulus())
      {}

      double strain_energy(const Tensor<2, dim> &F) const override
      {
        const Tensor<2, dim> E = strain(F);
        return 0.5 * lambda * trace(E) * trace(E) + mu * E.norm_square();
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const override
      {
        return F * second_piola_kirchhoff_stress(F);
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F) const override
      {
        const Tensor<2, dim> S = second_piola_kirchhoff_stress(F);
        const Tensor<2, dim> B = F * transpose(F);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return (i == k ? S[L][J] : 0.) + lambda * F[i][J] * F[k][L] +
                 mu * (F[i][L] * F[k][J] + (J == L ? B[i][k] : 0.));
        });
      }

    private:
      static Tensor<2, dim> strain(const Tensor<2, dim> &F)
      {
        return 0.5 * (transpose(F) * F - unit_symmetric_tensor<dim>());
      }

      Tensor<2, dim> second_piola_kirchhoff_stress(const Tensor<2, dim> &F) const
      {
        const Tensor<2, dim> E = strain(F);
        return lambda * trace(E) * unit_symmetric_tensor<dim>() + 2. * mu * E;
      }

      const double mu;
      const double lambda;
    };

    /**
     * Any other material plus kappa/2 (ln J)^2. The tangent is that of the
     * linearised ln J, kappa F^-T F^-T: what it leaves out is indefinite and
     * inverted cells in which ln J had become large.
     */
    template <int dim>
    class VolumetricallyStabilised : public StressModel<dim>
    {
    public:
      VolumetricallyStabilised(std::unique_ptr<StressModel<dim>> material, const double kappa)
          : material(std::move(material))
          , kappa(kappa)
      {}

      double strain_energy(const Tensor<2, dim> &F) const override
      {
        const double log_J = std::log(positive_determinant(F));
        return material->strain_energy(F) + 0.5 * kappa * log_J * log_J;
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const override
      {
        return material->first_piola_kirchhoff_stress(F) +
               kappa * std::log(positive_determinant(F)) * inverse_transpose(F);
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F) const override
      {
        const Tensor<2, dim> G = inverse_transpose(F);
        return material->tangent(F) + make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
                 return kappa * G[i][J] * G[k][L];
               });
      }

    private:
      const std::unique_ptr<StressModel<dim>> material;
      const double                            kappa;
    };

    /**
     * Any other material without the stress across a thin part of the body, whose faces
     * have the normal N: W(F*) with
     *   F* = F + (1 - J)/|c|^2 c N^T,  c = cof(F) N,  det F* = 1,
     * F stretched along the normal c of the deformed faces to the reference volume.
     */
    template <int dim>
    class ThinMaterial : public StressModel<dim>
    {
    public:
      ThinMaterial(std::unique_ptr<StressModel<dim>> material, const Tensor<1, dim> &normal)
          : material(std::move(material))
          , normal(normal)
      {}

      double strain_energy(const Tensor<2, dim> &F) const override
      {
        return material->strain_energy(Stretch(F, normal).stretched_F);
      }

      /** With t = P(F*) N: P(F*) - t.c/|c|^2 cof F + (1 - J) w.dc/dF, see Stretch. */
      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F) const override
      {
        const Stretch        stretch(F, normal);
        const Tensor<2, dim> P = material->first_piola_kirchhoff_stress(stretch.stretched_F);
        const Tensor<1, dim> t = P * normal;
        return P - stretch.get_normal_stress(t) * stretch.cofactor +
               (1. - stretch.J) * stretch.get_turning_stress(t);
      }

      /** The second derivative of W(F*) where J = 1. */
      Tensor<4, dim> tangent(const Tensor<2, dim> &F) const override
      {
        const Stretch         stretch(F, normal);
        const Tensor<2, dim>  P   = material->first_piola_kirchhoff_stress(stretch.stretched_F);
        const Tensor<4, dim>  A   = material->tangent(stretch.stretched_F);
        const Tensor<1, dim>  t   = P * normal;
        const Tensor<2, dim> &cof = stretch.cofactor;
        const double          s   = stretch.get_normal_stress(t);

        // A applied to the stretch of a unit change of volume
        Tensor<2, dim> by_volume;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            by_volume[i][J] = stretch.get_normal_stress(A[i][J] * normal);
        const double         twice = stretch.get_normal_stress(by_volume * normal);
        const Tensor<2, dim> mixed = by_volume + stretch.get_turning_stress(t);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return A[i][J][k][L] - cof[i][J] * mixed[k][L] - mixed[i][J] * cof[k][L] +
                 twice * cof[i][J] * cof[k][L] -
                 s / stretch.J * (cof[i][J] * cof[k][L] - cof[i][L] * cof[k][J]);
        });
      }

    private:
      struct Stretch
      {
        Stretch(const Tensor<2, dim> &F, const Tensor<1, dim> &normal)
            : J(positive_determinant(F))
            , inverse(inverse_transpose(F))
            , cofactor(J * inverse)
            , c(cofactor * normal)
            , stretched_F(F + (1. - J) / c.norm_square() * outer_product(c, normal))
        {}

        /** t.c/|c|^2, the work of the traction t on a unit change of volume. */
        double get_normal_stress(const Tensor<1, dim> &t) const
        {
          return t * c / c.norm_square();
        }

        /** w.dc/dF with w = (t - 2 (t.c) c/|c|^2)/|c|^2, the derivative of t.c/|c|^2 by c. */
        Tensor<2, dim> get_turning_stress(const Tensor<1, dim> &t) const
        {
          const Tensor<1, dim> w = (t - 2. * get_normal_stress(t) * c) / c.norm_square();
          return (w * c) * inverse - outer_product(c, w * inverse);
        }

        const double         J;
        const Tensor<2, dim> inverse; // transposed
        const Tensor<2, dim> cofactor;
        const Tensor<1, dim> c;
        const Tensor<2, dim> stretched_F;
      };

      const std::unique_ptr<StressModel<dim>> material;
      const Tensor<1, dim>                    normal;
    };

    template <int dim>
    const Factory<StressModel<dim>, const MaterialParameters &> &get_factory()
    {
      using Parameters = MaterialParameters;
      static const Factory<StressModel<dim>, const Parameters &> factory(
          "material",
          {{"none", [](const Parameters &p) { return std::make_unique<NoStress<dim>>(p); }},
           {"neo-Hookean",
            [](const Parameters &p) { return std::make_unique<NeoHookean<dim>>(p); }},
           {"modified neo-Hookean",
            [](const Parameters &p) { return std::make_unique<ModifiedNeoHookean<dim>>(p); }},
           {"St. Venant-Kirchhoff",
            [](const Parameters &p) { return std::make_unique<StVenantKirchhoff<dim>>(p); }}});
      return factory;
    }
  } // namespace

  void MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Material", material,
                      "The hyperelastic material: 'neo-Hookean' is incompressible, P = mu (F - "
                      "F^-T); 'modified neo-Hookean' has the isochoric energy mu/2 (J^(-2/dim) "
                      "tr(F^T F) - dim); 'St. Venant-Kirchhoff' is linear in the Green-Lagrange "
                      "strain; 'none' has no elastic stress.",
                      Patterns::Selection(get_factory<2>().get_names()));
    prm.add_parameter("Young's modulus", youngs_modulus,
                      "Young's modulus E [Pa]; used if the shear modulus is 0.",
                      Patterns::Double());
    prm.add_parameter("Shear modulus", shear_modulus,
                      "Shear modulus mu [Pa]. 0 takes it from Young's modulus: E/3 for the "
                      "neo-Hookean materials, E/(2 (1 + nu)) for St. Venant-Kirchhoff's.",
                      Patterns::Double());
    prm.add_parameter("Poisson ratio", poisson_ratio,
                      "Poisson ratio nu [-] of St. Venant-Kirchhoff's material; the neo-Hookean "
                      "ones are incompressible.",
                      Patterns::Double());
    prm.add_parameter(
        "Thin direction", thin_direction,
        "For a thin part of the body, the direction across it in the body's frame: the "
        "stress across it is left to the fluid's pressure. This does not change an "
        "incompressible material, but the pressure then does not jump at its faces by "
        "the stress of the bent body, and loads on it become more exact.",
        Patterns::Selection("none|x|y|z"));
    prm.add_parameter("Volumetric stabilisation", volumetric_stabilisation,
                      "Modulus kappa [Pa] of the energy kappa/2 (ln J)^2 that is added to any "
                      "material against volume errors of the interpolated motion.",
                      Patterns::Double());
  }

  void MaterialParameters::check(const std::string &path) const
  {
    const auto bad = [&path](const std::string &entry, const double value) {
      return path + "/" + entry + ": the value is " + Patterns::Tools::to_string(value) + ". ";
    };
    AssertThrow(std::isfinite(volumetric_stabilisation) && volumetric_stabilisation >= 0.,
                ExcMessage(bad("Volumetric stabilisation", volumetric_stabilisation) +
                           "Give a modulus that is not negative [Pa]."));
    if (material == "none")
      return;

    AssertThrow(std::isfinite(shear_modulus) && shear_modulus >= 0.,
                ExcMessage(bad("Shear modulus", shear_modulus) +
                           "Give a positive modulus [Pa], or 0 to take it from Young's."));
    AssertThrow(shear_modulus > 0. || (std::isfinite(youngs_modulus) && youngs_modulus > 0.),
                ExcMessage(bad("Young's modulus", youngs_modulus) +
                           "Give a positive modulus [Pa], or a positive shear modulus."));
    if (material == "St. Venant-Kirchhoff")
      AssertThrow(poisson_ratio > -1. && poisson_ratio < 0.5,
                  ExcMessage(bad("Poisson ratio", poisson_ratio) +
                             "Give a ratio above -1 and below 0.5; for an incompressible body "
                             "choose the neo-Hookean material."));
  }

  double MaterialParameters::get_shear_modulus() const
  {
    if (shear_modulus > 0.)
      return shear_modulus;
    const double nu = (material == "St. Venant-Kirchhoff") ? poisson_ratio : 0.5;
    return youngs_modulus / (2. * (1. + nu));
  }

  double MaterialParameters::get_lame_modulus() const
  {
    return 2. * get_shear_modulus() * poisson_ratio / (1. - 2. * poisson_ratio);
  }

  template <int dim>
  std::unique_ptr<StressModel<dim>> create_stress_model(const MaterialParameters &parameters)
  {
    auto         material = get_factory<dim>().create(parameters.material, parameters);
    const double kappa    = parameters.volumetric_stabilisation;
    if (parameters.thin_direction != "none")
    {
      Tensor<1, dim> normal;
      normal[parameters.thin_direction[0] - 'x'] = 1.;
      material = std::make_unique<ThinMaterial<dim>>(std::move(material), normal);
    }
    if (kappa > 0.)
      return std::make_unique<VolumetricallyStabilised<dim>>(std::move(material), kappa);
    return material;
  }

  template class StressModel<2>;
  template class StressModel<3>;
  template std::unique_ptr<StressModel<2>> create_stress_model(const MaterialParameters &);
  template std::unique_ptr<StressModel<3>> create_stress_model(const MaterialParameters &);
} // namespace caudal

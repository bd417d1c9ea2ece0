#include <caudal/base/expression.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>

using namespace dealii;

namespace caudal
{
  template <int dim>
  std::unique_ptr<FunctionParser<dim>> make_expression(const std::string &path,
                                                       const std::string &expression,
                                                       const unsigned int n_components)
  {
    const std::string variables = FunctionParser<dim>::default_variable_names() + ",t";
    AssertThrow(Utilities::split_string_list(expression, ';').size() == n_components,
                ExcMessage(path + ": <" + expression + "> has not " + std::to_string(n_components) +
                           " component(s). Separate the components by ';'."));
    auto        function = std::make_unique<FunctionParser<dim>>(n_components);
    std::string reason;
    try
    {
      function->initialize(variables, expression, {{"pi", numbers::PI}}, /*time_dependent=*/true);
      function->value(Point<dim>());
    }
    catch (const std::exception &exception)
    {
      reason = "invalid";
    }
    AssertThrow(reason.empty(),
                ExcMessage(path + ": <" + expression + "> is not a valid function of " + variables +
                           ". See https://beltoforion.de/en/muparser for what it may contain."));
    return function;
  }

  template <int dim>
  void check_finite(const std::string &path, const std::string &expression,
                    const Function<dim> &function, const Point<dim> &point)
  {
    for (unsigned int c = 0; c < function.n_components; ++c)
      if (!std::isfinite(function.value(point, c)))
      {
        std::ostringstream place;
        place << "(" << point << "), t = " << function.get_time() << " s";
        AssertThrow(false, ExcMessage(path + ": <" + expression + "> is not a finite number at " +
                                      place.str() + ". Give a function that is defined there."));
      }
  }

  template std::unique_ptr<FunctionParser<2>> make_expression<2>(const std::string &,
                                                                 const std::string &, unsigned int);
  template std::unique_ptr<FunctionParser<3>> make_expression<3>(const std::string &,
                                                                 const std::string &, unsigned int);
  template void check_finite(const std::string &, const std::string &, const Function<2> &,
                             const Point<2> &);
  template void check_finite(const std::string &, const std::string &, const Function<3> &,
                             const Point<3> &);
} // namespace caudal

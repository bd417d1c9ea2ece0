#include <caudal/fish/body_function.h>

#include <cmath>

namespace caudal
{
  BodyFunction::BodyFunction(const std::string &path, const std::string &variables,
                             const std::string &expression)
      : path(path)
      , variables(variables)
      , expression(expression)
  {
    bool valid = true;
    try
    {
      function.initialize(variables, expression, {{"pi", numbers::PI}});
      function.value(Point<2>());
    }
    catch (const std::exception &)
    {
      valid = false;
    }
    AssertThrow(valid,
                ExcMessage(path + ": <" + expression + "> is not a valid function of " + variables +
                           ". See https://beltoforion.de/en/muparser for what it may contain."));
  }

  double BodyFunction::value(const double first, const double second) const
  {
    const double value = function.value(Point<2>(first, second));
    AssertThrow(std::isfinite(value),
                ExcMessage(path + ": <" + expression + "> is not a finite number at (" + variables +
                           ") = (" + std::to_string(first) + "," + std::to_string(second) +
                           "). Give a function that is defined there."));
    return value;
  }

  void BodyFunction::check_along() const
  {
    for (const double s : {0., 0.25, 0.5, 0.75, 1.})
      value(s, 0.);
  }
} // namespace caudal

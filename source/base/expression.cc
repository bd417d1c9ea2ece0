// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>

#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>

namespace caudal
{
  template <int dim>
  Expression<dim>::Expression(const std::string &path, const std::string &text,
                              const unsigned int n_components)
      : Function<dim>(n_components)
      , path(path)
      , variables(FunctionParser<dim>::default_variable_names() + ",t")
      , text(text)
      , is_in_space(true)
      , function(n_components)
  {
    AssertThrow(Utilities::split_string_list(text, ';').size() == n_components,
                ExcMessage(path + ": <" + text + "> has not " + std::to_string(n_components) +
                           " component(s). Separate the components by ';'."));
    parse();
  }

  template <int dim>
  Expression<dim>::Expression(const std::string &path, const std::string &variables,
                              const std::string &text)
      : path(path)
      , variables(variables)
      , text(text)
      , is_in_space(false)
  {
    parse();
  }

  template <int dim>
  Expression<dim>::Expression(const Expression &other)
      : Function<dim>(other)
      , path(other.path)
      , variables(other.variables)
      , text(other.text)
      , is_in_space(other.is_in_space)
      , function(other.n_components)
  {
    parse();
    function.set_time(other.get_time());
  }

  template <int dim>
  void Expression<dim>::parse()
  {
    bool               is_valid = true;
    std::ostringstream reason; // deal.II prints muParser's
    const auto         terminal = std::cerr.rdbuf(reason.rdbuf());
    try
    {
      function.initialize(variables, text, {{"pi", numbers::PI}}, /*time_dependent=*/is_in_space);
      function.value(Point<dim>());
    }
    catch (const std::exception &)
    {
      is_valid = false;
    }
    std::cerr.rdbuf(terminal);
    if (is_valid)
      return;
    std::smatch       message;
    const std::string reasons = reason.str();
    const bool has_message = std::regex_search(reasons, message, std::regex("Message:\\s*<(.*)>"));
    AssertThrow(false,
                ExcMessage(path + ": <" + text + "> is not a valid function of " + variables +
                           (has_message ? " (" + message[1].str() + ")" : "") +
                           ". See https://beltoforion.de/en/muparser for what it may contain."));
  }

  template <int dim>
  double Expression<dim>::value(const Point<dim> &point, const unsigned int component) const
  {
    const double result = function.value(point, component);
    check(result, point);
    return result;
  }

  template <int dim>
  void Expression<dim>::vector_value(const Point<dim> &point, Vector<double> &values) const
  {
    function.vector_value(point, values);
    for (const double value : values)
      check(value, point);
  }

  template <int dim>
  void Expression<dim>::set_time(const double time)
  {
    Function<dim>::set_time(time);
    function.set_time(time);
  }

  template <int dim>
  void Expression<dim>::check(const double value, const Point<dim> &point) const
  {
    AssertThrow(std::isfinite(value),
                ExcMessage(path + ": <" + text + "> is not a finite number at " +
                           describe_place(point) + ". Give a function that is defined there."));
  }

  template <int dim>
  std::string Expression<dim>::describe_place(const Point<dim> &point) const
  {
    std::ostringstream place;
    if (is_in_space)
      place << '(' << point << "), t = " << this->get_time() << " s";
    else
    {
      place << '(' << variables << ") = (";
      for (unsigned int d = 0; d < dim; ++d)
        place << (d > 0 ? "," : "") << std::to_string(point[d]);
      place << ')';
    }
    return place.str();
  }

  template class Expression<2>;
  template class Expression<3>;
} // namespace caudal
